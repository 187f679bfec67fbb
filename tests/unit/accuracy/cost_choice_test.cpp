#include "accuracy/cost_choice.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace vernier {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(ParetoFrontTest, KeepsWhatNothingBeats) {
  const std::vector<CostAndError> points{{4.0, 0.1}, {1.0, 0.4}, {2.0, 0.5}, {2.0, 0.2}, {5.0, 0.1}};
  EXPECT_EQ(pareto_front(points), (std::vector<std::size_t>{1, 3, 0}));
}

TEST(ParetoFrontTest, EqualPointsCountOnceAndUnknownOnesNever) {
  const std::vector<CostAndError> points{{1.0, kNaN}, {1.0, 0.3}, {1.0, 0.3}, {kInfinity, 0.0}, {kNaN, 0.0}};
  EXPECT_EQ(pareto_front(points), (std::vector<std::size_t>{1}));
  EXPECT_TRUE(pareto_front({}).empty());
}

TEST(CheapestWithinTest, IsTheFastestThatIsGoodEnough) {
  const std::vector<CostAndError> points{{4.0, 0.1}, {1.0, 0.4}, {2.0, 0.2}, {0.5, kNaN}};
  EXPECT_EQ(cheapest_within(points, 0.2), 2u);
  EXPECT_EQ(cheapest_within(points, 0.19), 0u);
  EXPECT_EQ(cheapest_within(points, 0.05), std::nullopt);
}

TEST(LogSlopeTest, FindsThePower) {
  std::vector<CostAndError> points;
  for (const double time : {1.0, 3.0, 10.0, 70.0}) points.push_back({time, 2.0 / std::sqrt(time)});
  ASSERT_TRUE(log_slope(points));
  EXPECT_NEAR(*log_slope(points), -0.5, 1e-12);  // a few roundings of sums of order 10
}

TEST(LogSlopeTest, ThereIsNoneWithoutTwoTimes) {
  EXPECT_EQ(log_slope({}), std::nullopt);
  EXPECT_EQ(log_slope(std::vector<CostAndError>{{2.0, 1.0}}), std::nullopt);
  EXPECT_EQ(log_slope(std::vector<CostAndError>{{2.0, 1.0}, {2.0, 3.0}}), std::nullopt);
  EXPECT_EQ(log_slope(std::vector<CostAndError>{{2.0, 1.0}, {3.0, 0.0}}), std::nullopt);
}

TEST(RoundErrorsTest, FallsInOneTwoFive) {
  const std::vector<double> errors = round_errors(0.015, 0.3);
  const std::vector<double> expected{0.2, 0.1, 0.05, 0.02};
  ASSERT_EQ(errors.size(), expected.size());
  for (std::size_t i = 0; i < errors.size(); ++i) EXPECT_DOUBLE_EQ(errors[i], expected[i]);
  EXPECT_TRUE(round_errors(0.0, 1.0).empty());
  EXPECT_TRUE(round_errors(kInfinity, 0.0).empty());
}

}  // namespace
}  // namespace vernier
