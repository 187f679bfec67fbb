#include "math/parallel_for.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <vector>

namespace vernier {
namespace {

TEST(ParallelFor, CallsEveryIndexOnce) {
  for (const unsigned thread_count : {1u, 2u, 7u}) {
    std::vector<std::atomic<int>> calls(1000);
    parallel_for(thread_count, calls.size(), [&](std::size_t i) { ++calls[i]; });
    for (const auto& count : calls) {
      EXPECT_EQ(count, 1);
    }
  }
}

TEST(ParallelFor, OfNothingDoesNothing) {
  parallel_for(4, 0, [](std::size_t) { FAIL(); });
}

TEST(ParallelFor, ThrowsAgainWhatTheWorkThrew) {
  const auto fail = [](std::size_t i) {
    if (i == 500) {
      throw std::runtime_error("500");
    }
  };
  EXPECT_THROW(parallel_for(1, 1000, fail), std::runtime_error);
  EXPECT_THROW(parallel_for(3, 1000, fail), std::runtime_error);
}

TEST(ResolveThreadCount, IsAtLeastOne) {
  EXPECT_GE(resolve_thread_count(0), 1u);
  EXPECT_EQ(resolve_thread_count(3), 3u);
}

}  // namespace
}  // namespace vernier
