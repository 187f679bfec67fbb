#include "accuracy/interval.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace vernier {
namespace {

TEST(IntervalTest, ValuesWorkedByHand) {
  // Mean 3, deviation sqrt(2.5), t of 4 degrees 2.776: half width 2.776 sqrt(2.5 / 5) = 1.963.
  const std::vector<double> values{1.0, 2.0, 3.0, 4.0, 5.0};
  const Interval interval = interval_of(values);
  constexpr double kDigits = 5e-4;  // of the table and of the value above
  EXPECT_DOUBLE_EQ(interval.mean, 3.0);
  EXPECT_NEAR(interval.low, 1.037, kDigits);
  EXPECT_NEAR(interval.high, 4.963, kDigits);
  EXPECT_NEAR(bound_of_next(values), 3.0 + 2.776 * std::sqrt(2.5 * 1.2), kDigits);
}

TEST(IntervalTest, OneValueTellsNothing) {
  const Interval interval = interval_of(std::vector<double>{2.0});
  EXPECT_DOUBLE_EQ(interval.mean, 2.0);
  EXPECT_TRUE(std::isinf(interval.low));
  EXPECT_TRUE(std::isinf(interval.high));
}

TEST(IntervalTest, CoversAsOftenAsItSays) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal(5.0, 2.0);
  constexpr int kTrials = 10000;
  int covered = 0;
  int below = 0;
  for (int trial = 0; trial < kTrials; ++trial) {
    std::vector<double> values(4);
    for (double& value : values) value = normal(random);
    const Interval interval = interval_of(values);
    covered += interval.low <= 5.0 && 5.0 <= interval.high;
    below += normal(random) <= bound_of_next(values);
  }
  // Five standard deviations of a count of 10000 with 0.95 (0.0022) and 0.975 (0.0016).
  EXPECT_NEAR(static_cast<double>(covered) / kTrials, 0.95, 0.011);
  EXPECT_NEAR(static_cast<double>(below) / kTrials, 0.975, 0.008);
}

TEST(IntervalTest, QuantilesFallTowardsTheNormalOne) {
  for (std::size_t degrees = 1; degrees < 40; ++degrees) EXPECT_LE(student_t(degrees + 1), student_t(degrees));
  EXPECT_DOUBLE_EQ(student_t(1000), 1.96);
}

}  // namespace
}  // namespace vernier
