#include "accuracy/error_figures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace vernier {
namespace {

constexpr int kSide = 64;

/// Grey `level` plus `offset`, with noise of deviation 0.1.
Image noisy(float level, float offset, std::mt19937& random) {
  std::normal_distribution<float> normal(level + offset, 0.1f);
  Image image{kSide, kSide, 4, std::vector<float>(kSide * kSide * 4)};
  for (float& value : image.values) value = normal(random);
  return image;
}

TEST(BiasProductTest, NoiseCancelsAndBiasStays) {
  std::mt19937 random(7);
  const float level = 1.0f;
  const Image ra = noisy(level, 0.0f, random);
  const Image rb = noisy(level, 0.0f, random);
  // Of 12288 products of noise of variance 0.02 each, weighted by about 1: deviation 0.02 / 111 = 0.00018; five of
  // them.
  constexpr double kNoise = 0.0009;
  EXPECT_NEAR(bias_product(noisy(level, 0.0f, random), noisy(level, 0.0f, random), ra, rb), 0.0, kNoise);
  // 0.2^2 / (1 + 0.01), the noise of the weight and of the bias times noise added: 2 x 0.2 x 0.14 / 111 and 1 % of it.
  EXPECT_NEAR(bias_product(noisy(level, 0.2f, random), noisy(level, 0.2f, random), ra, rb), 0.04 / 1.01, 3.0 * kNoise);
}

TEST(BiasProductTest, LeavesOutWhatIsNotFinite) {
  std::mt19937 random(7);
  Image a = noisy(0.0f, 0.5f, random);
  a.values[0] = std::numeric_limits<float>::quiet_NaN();
  const Image b = noisy(0.0f, 0.5f, random);
  EXPECT_TRUE(std::isfinite(bias_product(a, b, b, b)));
}

TEST(ErrorFiguresTest, TheRelativeErrorIsTheRootOfRelMse) {
  const Image reference{1, 1, 4, {1.0f, 1.0f, 1.0f, 1.0f}};
  const Image picture{1, 1, 4, {1.5f, 1.0f, 1.0f, 1.0f}};
  const ErrorFigures figures = error_figures(picture, reference, flip(reference, picture));
  EXPECT_NEAR(figures.rel_mse, 0.25 / 1.01 / 3.0, 1e-12);  // a few roundings of double
  EXPECT_DOUBLE_EQ(figures.rel_error, std::sqrt(figures.rel_mse));
  EXPECT_DOUBLE_EQ(figures.most, 0.5);
}

TEST(ErrorFiguresTest, TheMeanOfTwoImages) {
  const Image mean = mean_image({1, 1, 1, {1.0f}}, {1, 1, 1, {4.0f}});
  EXPECT_FLOAT_EQ(mean.values[0], 2.5f);
}

}  // namespace
}  // namespace vernier
