#include "image/difference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "expect_error.h"

namespace vernier {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

Image rgb(int width, int height, std::vector<float> values) {
  return Image{width, height, 3, std::move(values)};
}

// Dyadic values, so that every square is exact: a - b is 0.5 in red of pixel 0 and -0.25 in blue of pixel 1.
TEST(Difference, AgreesWithValuesWorkedByHand) {
  const Image a = rgb(2, 1, {1.0f, 0.0f, 0.0f, 0.5f, 0.5f, 0.25f});
  const Image b = rgb(2, 1, {0.5f, 0.0f, 0.0f, 0.5f, 0.5f, 0.5f});
  const Difference difference = compare_images(a, b);
  const double mean_square = (0.25 + 0.0625) / 6.0;
  EXPECT_DOUBLE_EQ(difference.rmse, std::sqrt(mean_square));
  EXPECT_DOUBLE_EQ(difference.rel_mse, (0.25 / 0.26 + 0.0625 / 0.26) / 6.0);
  EXPECT_NEAR(difference.psnr_db, -10.0 * std::log10(mean_square), 1e-12);
  EXPECT_EQ(difference.max_absolute, 0.5);
  EXPECT_EQ(difference.max_x, 0);
  EXPECT_EQ(difference.max_channel, 0);
  EXPECT_EQ(difference.mean_signed, (std::array<double, 3>{0.25, 0.0, -0.125}));
  EXPECT_EQ(difference.compared_pixels, 2u);
  EXPECT_TRUE(difference.finite);
}

TEST(Difference, OfEqualImagesIsZero) {
  const Image a = rgb(1, 2, {0.1f, 0.2f, 0.3f, 7.0f, -1.0f, 0.0f});
  const Difference difference = compare_images(a, a);
  EXPECT_EQ(difference.rmse, 0.0);
  EXPECT_EQ(difference.rel_mse, 0.0);
  EXPECT_EQ(difference.max_absolute, 0.0);
  EXPECT_EQ(difference.psnr_db, std::numeric_limits<double>::infinity());
}

TEST(Difference, RelativeErrorIsThatOfTheSecondImage) {
  const Difference bright = compare_images(rgb(1, 1, {0, 0, 0}), rgb(1, 1, {1, 1, 1}));
  const Difference dark = compare_images(rgb(1, 1, {1, 1, 1}), rgb(1, 1, {0, 0, 0}));
  EXPECT_DOUBLE_EQ(bright.rel_mse, 1.0 / 1.01);
  EXPECT_DOUBLE_EQ(dark.rel_mse, 100.0);
}

TEST(Difference, PlaceOfTheLargestIsTheFirstInRowOrder) {
  Image a = rgb(3, 2, std::vector<float>(18, 0.0f));
  const Image b = a;
  a.values[(1 * 3 + 1) * 3 + 2] = -2.0f;
  a.values[(1 * 3 + 2) * 3 + 0] = 2.0f;
  const Difference difference = compare_images(a, b);
  EXPECT_EQ(difference.max_x, 1);
  EXPECT_EQ(difference.max_y, 1);
  EXPECT_EQ(difference.max_channel, 2);
}

TEST(Difference, CountsNonFinitePixelsAndLeavesThemOut) {
  const Image a = rgb(3, 1, {kNan, kNan, 0, 1, 1, 1, 0, 0, 0});
  const Image b = rgb(3, 1, {0, 0, 0, 0.5f, 1, 1, 0, INFINITY, 0});
  const Difference difference = compare_images(a, b);
  EXPECT_EQ(difference.non_finite_a, 1u);
  EXPECT_EQ(difference.non_finite_b, 1u);
  EXPECT_EQ(difference.compared_pixels, 1u);
  EXPECT_FALSE(difference.finite);
  EXPECT_DOUBLE_EQ(difference.rmse, std::sqrt(0.25 / 3.0));
}

TEST(Difference, OfNothingLeftIsNan) {
  const Difference difference = compare_images(rgb(1, 1, {kNan, 0, 0}), rgb(1, 1, {0, 0, 0}));
  EXPECT_TRUE(std::isnan(difference.rmse));
  EXPECT_TRUE(std::isnan(difference.rel_mse));
  EXPECT_EQ(difference.max_x, -1);
  EXPECT_FALSE(difference.finite);
}

TEST(Difference, IgnoresAlphaAndSpreadsGrey) {
  const Image a{1, 1, 4, {0.5f, 0.5f, 0.5f, 0.0f}};
  EXPECT_EQ(compare_images(a, Image{1, 1, 1, {0.5f}}).max_absolute, 0.0);
  EXPECT_EQ(compare_images(a, Image{1, 1, 4, {0.5f, 0.5f, 0.5f, 1.0f}}).max_absolute, 0.0);
}

TEST(Difference, RefusesWhatCannotBeCompared) {
  const Image a = rgb(1, 1, {0, 0, 0});
  expect_error(ErrorKind::usage, "1 x 1 and 2 x 1", [&] { compare_images(a, rgb(2, 1, {0, 0, 0, 0, 0, 0})); });
  expect_error(ErrorKind::usage, "no pixels", [] { compare_images(Image{}, Image{}); });
  expect_error(ErrorKind::usage, "2 channels", [&] { compare_images(a, Image{1, 1, 2, {0, 0}}); });
  expect_error(ErrorKind::usage, "2 values", [&] { compare_images(a, Image{1, 1, 3, {0, 0}}); });
}

}  // namespace
}  // namespace vernier
