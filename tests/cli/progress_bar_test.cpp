#include "cli/progress_bar.h"

#include <gtest/gtest.h>

#include <limits>

namespace vernier {
namespace {

TEST(ProgressLine, ShareRateAndTimeLeft) {
  EXPECT_EQ(progress_line({0.5, 12.34e6, 64.2, ""}, 4), "[##--]  50 %  12.34 Mrays/s  ETA 1:05");
  EXPECT_EQ(progress_line({1.0, 0.0, 0.0, ""}, 0), "100 %");
  EXPECT_EQ(progress_line({0.5, 0.0, 2.0, "BVH"}, 4), "BVH [##--]  50 %  ETA 0:02");
  EXPECT_EQ(progress_line({0.009, 0.0, 9000.0, "BVH"}, 4), "BVH [----]   0 %") << "begun a moment ago: no estimate";
}

TEST(ProgressLine, UnknownFiguresAreLeftOut) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(progress_line({kNan, kNan, kInfinity, ""}, 2), "[--]   0 %");
  EXPECT_EQ(progress_line({-1.0, kInfinity, 1e300, ""}, 2), "[--]   0 %");
  EXPECT_EQ(progress_line({7.0, -1.0, -1.0, ""}, 2), "[##] 100 %");
}

TEST(RateText, ThousandsAndMillions) {
  EXPECT_EQ(rate_text(99999.0), "100.00 krays/s");
  EXPECT_EQ(rate_text(100000.0), "0.10 Mrays/s");
  EXPECT_EQ(rate_text(0.0), "0.00 krays/s");
}

TEST(ClockText, MinutesAndHours) {
  EXPECT_EQ(clock_text(0.2), "0:01");
  EXPECT_EQ(clock_text(3599.0), "59:59");
  EXPECT_EQ(clock_text(3661.0), "1:01:01");
}

}  // namespace
}  // namespace vernier
