#include "math/thread_team.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace vernier {
namespace {

TEST(ThreadTeam, CallsEveryIndexOnceInEveryRun) {
  for (const unsigned thread_count : {1u, 2u, 7u}) {
    ThreadTeam team(thread_count);
    EXPECT_EQ(team.thread_count(), thread_count);
    // Short runs in a row: helpers come late, and must not take part in the next run by the counts of the last.
    for (std::size_t count = 0; count < 300; ++count) {
      std::vector<std::atomic<int>> calls(count);
      team.run(count, [&](std::size_t i) { ++calls[i]; });
      for (const auto& called : calls) EXPECT_EQ(called, 1);
    }
  }
}

TEST(ThreadTeam, ThrowsAgainWhatTheWorkThrewAndGoesOn) {
  for (const unsigned thread_count : {1u, 3u}) {
    ThreadTeam team(thread_count);
    const auto fail = [](std::size_t i) {
      if (i == 500) throw std::runtime_error("500");
    };
    EXPECT_THROW(team.run(1000, fail), std::runtime_error);
    std::atomic<int> calls = 0;
    team.run(100, [&](std::size_t) { ++calls; });
    EXPECT_EQ(calls, 100);
  }
}

TEST(ThreadTeam, EndsWithoutHavingWorked) {
  const ThreadTeam team(4);
}

}  // namespace
}  // namespace vernier
