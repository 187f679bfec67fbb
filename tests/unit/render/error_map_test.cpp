#include "render/error_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace vernier {
namespace {

/// A film of `width` x `height` whose pixel (x, y) is grey of value(x, y) after samples(x, y) samples of one ray each.
template <typename Value, typename Samples>
DevelopedFilm film_of(int width, int height, const Value& value, const Samples& samples) {
  DevelopedFilm film;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const auto grey = static_cast<float>(value(x, y));
      for (const float channel : {grey, grey, grey, 1.0f}) film.color.push_back(channel);
      for (const float count : {1.0f, 0.0f, 0.0f}) film.cost.push_back(count);
      film.sample_count.push_back(samples(x, y));
    }
  }
  return film;
}

const auto kNothing = [](int, int) { return 0.0; };

auto always(std::uint32_t count) {
  return [count](int, int) { return count; };
}

TEST(ErrorMap, the_step_of_a_mean_is_its_error_by_hand) {
  ErrorMap errors(1, 1);
  errors.update(film_of(
      1, 1, [](int, int) { return 1.0; }, always(4)));
  errors.update(film_of(
      1, 1, [](int, int) { return 0.5; }, always(8)));
  // (1 - 0.5)^2 / (0.5^2 + 0.01) by doubling; one pixel: as large as its own standard error.
  EXPECT_NEAR(errors.estimate().rel_mse, 0.25 / 0.26, 1e-7);  // error_ holds floats: half an ulp of 1 is 6e-8
  EXPECT_NEAR(errors.estimate().standard_error, 0.25 / 0.26, 1e-7);
  // From 8 to 12 samples: step^2 m / (n - m).
  errors.update(film_of(
      1, 1, [](int, int) { return 0.6; }, always(12)));
  EXPECT_NEAR(errors.estimate().rel_mse, 2.0 * 0.01 / 0.37, 1e-7);
}

TEST(ErrorMap, independent_samples_have_the_error_that_is_estimated) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  const int side = 256;
  const double spread = 0.1;  // of one sample
  std::vector<double> sums(side * side);
  ErrorMap errors(side, side);
  for (const std::uint32_t count : {4u, 8u, 16u}) {
    for (double& sum : sums) {
      for (std::uint32_t s = count == 4 ? 0 : count / 2; s < count; ++s) sum += 1.0 + spread * normal(random);
    }
    errors.update(film_of(
        side, side, [&](int x, int y) { return sums[y * side + x] / count; }, always(count)));
  }
  const ErrorEstimate estimate = errors.estimate();
  const double truth = spread * spread / 16 / 1.01;
  // Of 65536 squares of a normal variable the mean is off by sqrt(2 / 65536) = 0.55 %: five times that. The
  // denominator's own noise is of the order of the truth, 6e-4.
  EXPECT_NEAR(estimate.rel_mse / truth, 1.0, 0.03);
  // E[e^2] = 3 sigma^4: sqrt(3 / 65536) of the mean.
  EXPECT_NEAR(estimate.standard_error / estimate.rel_mse, std::sqrt(3.0 / 65536), 0.1 * std::sqrt(3.0 / 65536));
}

TEST(ErrorMap, chooses_the_noisy_block_and_no_other) {
  ErrorMap errors(20, 20);
  const auto noise = [](double size) {
    return [size](int x, int y) { return x >= 8 && x < 16 && y < 8 ? 0.5 + size * ((x + y) % 2) : 0.5; };
  };
  errors.update(film_of(20, 20, noise(0.2), always(4)));
  errors.update(film_of(20, 20, noise(0.1), always(8)));
  EXPECT_EQ(errors.choose_blocks(0.01, 1024), (std::vector<std::uint32_t>{1}));
  EXPECT_EQ(errors.choose_blocks(0.01, 8), std::vector<std::uint32_t>{});  // it has as many as it may have
  EXPECT_EQ(errors.choose_blocks(10.0, 1024), std::vector<std::uint32_t>{});
}

TEST(ErrorMap, where_errors_are_equal_the_cheap_block_comes_first) {
  ErrorMap errors(16, 8);
  const auto noise = [](double size) { return [size](int x, int y) { return 0.5 + size * ((x + y) % 2); }; };
  DevelopedFilm film = film_of(16, 8, noise(0.2), always(4));
  for (std::size_t pixel = 0; pixel < film.sample_count.size(); ++pixel)
    film.cost[3 * pixel] = pixel % 16 < 8 ? 9.0f : 1.0f;
  errors.update(film);
  DevelopedFilm next = film_of(16, 8, noise(0.1), always(8));
  next.cost = film.cost;
  errors.update(next);
  const double bound = errors.estimate().bound();
  EXPECT_EQ(errors.choose_blocks(0.9 * bound, 1024), (std::vector<std::uint32_t>{1}));
  EXPECT_EQ(errors.choose_blocks(0.2 * bound, 1024), (std::vector<std::uint32_t>{0, 1}));
}

TEST(ErrorMap, blocks_at_the_border_are_cut) {
  const ErrorMap errors(20, 9);
  EXPECT_EQ(errors.block_columns(), 3);
  const PixelRect last = errors.block(5);
  EXPECT_EQ(last.x, 16);
  EXPECT_EQ(last.y, 8);
  EXPECT_EQ(last.width, 4);
  EXPECT_EQ(last.height, 1);
}

TEST(ErrorMap, pixels_that_are_not_finite_and_images_without_noise_ask_for_nothing) {
  ErrorMap errors(8, 8);
  const auto broken = [](int x, int) { return x == 3 ? std::numeric_limits<double>::quiet_NaN() : 0.25; };
  errors.update(film_of(8, 8, broken, always(4)));
  errors.update(film_of(8, 8, broken, always(8)));
  EXPECT_EQ(errors.estimate().bound(), 0.0);
  EXPECT_TRUE(errors.choose_blocks(1e-6, 1024).empty());
  ErrorMap black(8, 8);
  black.update(film_of(8, 8, kNothing, always(4)));
  black.update(film_of(8, 8, kNothing, always(8)));
  EXPECT_EQ(black.estimate().bound(), 0.0);
}

}  // namespace
}  // namespace vernier
