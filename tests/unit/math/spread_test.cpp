#include "math/spread.h"

#include <gtest/gtest.h>

namespace vernier {
namespace {

TEST(SpreadTest, TheMedianOfAnEvenNumberLiesBetween) {
  const Spread spread = spread_of({4.0, 1.0, 3.0, 2.0});
  EXPECT_DOUBLE_EQ(spread.median, 2.5);
  EXPECT_DOUBLE_EQ(spread.least, 1.0);
  EXPECT_DOUBLE_EQ(spread.most, 4.0);
}

TEST(SpreadTest, TheMedianOfAnOddNumberIsOneOfThem) {
  EXPECT_DOUBLE_EQ(spread_of({9.0, 1.0, 2.0}).median, 2.0);
}

}  // namespace
}  // namespace vernier
