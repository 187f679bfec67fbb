#include "image/srgb_curve.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vernier {
namespace {

TEST(SrgbCurve, HasTheValuesOfTheStandard) {
  EXPECT_EQ(srgb_from_linear(0.0), 0.0);
  EXPECT_NEAR(srgb_from_linear(1.0), 1.0, 1e-15);
  EXPECT_NEAR(srgb_from_linear(0.001), 0.01292, 1e-15);
  // 1.055 x 0.5^(1/2.4) - 0.055, worked out to ten digits.
  EXPECT_NEAR(srgb_from_linear(0.5), 0.7353569831, 1e-9);
  EXPECT_NEAR(linear_from_srgb(0.5), 0.2140411405, 1e-9);
}

TEST(SrgbCurve, EveryByteSurvivesTheWayThroughLinearFloat) {
  for (int byte = 0; byte < 256; ++byte) {
    const float linear = static_cast<float>(linear_from_srgb(byte / 255.0));
    EXPECT_EQ(std::lround(srgb_from_linear(linear) * 255.0), byte);
  }
}

TEST(SrgbCurve, PassesNanOn) {
  EXPECT_TRUE(std::isnan(srgb_from_linear(NAN)));
  EXPECT_TRUE(std::isnan(linear_from_srgb(NAN)));
}

}  // namespace
}  // namespace vernier
