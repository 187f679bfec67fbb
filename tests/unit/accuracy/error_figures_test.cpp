#include "accuracy/error_figures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace vernier {
namespace {

constexpr int kSide = 64;

/// Grey `level` with noise.
Image noisy(float level, float deviation, std::mt19937& random) {
  std::normal_distribution<float> normal(level, deviation);
  Image image{kSide, kSide, 4, std::vector<float>(kSide * kSide * 4)};
  for (float& value : image.values) value = normal(random);
  return image;
}

TEST(BiasProductTest, NoiseCancelsAndBiasStays) {
  std::mt19937 random(7);
  // A hundred times the samples of the pictures.
  const Image ra = noisy(1.0f, 0.01f, random);
  const Image rb = noisy(1.0f, 0.01f, random);
  const auto product = [&](float level) {
    const Image a = noisy(level, 0.1f, random);
    return bias_product(a, noisy(level, 0.1f, random), ra, rb);
  };
  // Of 12288 products of noise of variance 0.01: deviation 0.01 / 111. With a bias of 0.2 each noise is added 0.2
  // times: 0.2 sqrt(2) 0.1 / 111. Five of them each.
  EXPECT_NEAR(product(1.0f), 0.0, 0.00045);
  EXPECT_NEAR(product(1.2f), 0.04 / 1.01, 0.0013);
}

TEST(BiasProductTest, LeavesOutWhatIsNotFinite) {
  std::mt19937 random(7);
  Image a = noisy(0.5f, 0.1f, random);
  a.values[0] = std::numeric_limits<float>::quiet_NaN();
  const Image b = noisy(0.5f, 0.1f, random);
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
