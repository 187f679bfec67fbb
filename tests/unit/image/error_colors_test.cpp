#include "image/error_colors.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vernier {
namespace {

double luminance(const std::array<float, 3>& color) {
  return 0.2126 * color[0] + 0.7152 * color[1] + 0.0722 * color[2];
}

TEST(ErrorColors, GetBrighterAllTheWay) {
  constexpr int kSteps = 255;
  for (int step = 0; step < kSteps; ++step)
    EXPECT_LT(luminance(error_color(step / 255.0f)), luminance(error_color((step + 1) / 255.0f))) << step;
}

TEST(ErrorColors, BeginNearBlackAndEndNearWhite) {
  EXPECT_LT(luminance(error_color(0.0f)), 0.001);
  EXPECT_GT(luminance(error_color(1.0f)), 0.9);
}

TEST(ErrorColors, ClampToTheEndsAndMarkNan) {
  EXPECT_EQ(error_color(-1.0f), error_color(0.0f));
  EXPECT_EQ(error_color(INFINITY), error_color(1.0f));
  EXPECT_EQ(error_color(NAN), (std::array<float, 3>{1.0f, 0.0f, 1.0f}));
}

}  // namespace
}  // namespace vernier
