#include "reference/parallel_rows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace vernier::reference {
namespace {

TEST(ForEachRow, DoesEveryRowOnceAndReportsToTheEnd) {
  for (const unsigned threads : {0u, 1u, 3u, 50u}) {
    std::vector<int> calls(20, 0);
    std::vector<double> shares;
    for_each_row(
        20, threads, [&](int row) { ++calls[row]; }, [&](double share) { shares.push_back(share); });
    EXPECT_EQ(calls, std::vector<int>(20, 1));
    ASSERT_EQ(shares.size(), 20u);
    EXPECT_EQ(shares.back(), 1.0);
    EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  }
}

TEST(ForEachRow, PassesExceptionsOn) {
  const auto fail = [](int row) {
    if (row == 3) throw std::runtime_error("row 3");
  };
  EXPECT_THROW(for_each_row(10, 2, fail, {}), std::runtime_error);
}

TEST(ForEachRow, BeginsNoRowOnceCancelled) {
  int count = 0;
  for_each_row(
      20, 1, [&](int) { ++count; }, {}, [&] { return count == 7; });
  EXPECT_EQ(count, 7);
}

}  // namespace
}  // namespace vernier::reference
