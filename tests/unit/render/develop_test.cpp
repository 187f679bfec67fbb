#include "render/develop.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "error.h"
#include "shared/film_layout.h"

namespace vernier {
namespace {

/// Film words of one pixel with sums of `low`, `middle`, `high` in red.
std::vector<std::uint32_t> red_pixel(std::uint32_t low, std::uint32_t middle, std::uint32_t high,
                                     std::uint32_t samples) {
  std::vector<std::uint32_t> words(FILM_WORDS);
  words[FILM_RED] = low;
  words[FILM_RED + 1] = middle;
  words[FILM_RED + 2] = high;
  words[FILM_SAMPLES] = samples;
  return words;
}

float red_of(const std::vector<std::uint32_t>& words) {
  return develop(words, {0, 0, 1, 1}).color[0];
}

TEST(Develop, the_mean_of_fixed_point_sums) {
  EXPECT_EQ(red_of(red_pixel(0, 1u << 12, 0, 1)), 1.0f);
  EXPECT_EQ(red_of(red_pixel(0, 3u << 12, 0, 4)), 0.75f);
  EXPECT_EQ(red_of(red_pixel(1, 0, 0, 1)), 0x1p-44f);
  EXPECT_EQ(red_of(red_pixel(0, 0, 1u << 12, 1)), 0x1p32f);
  EXPECT_FLOAT_EQ(red_of(red_pixel(0xffffffffu, 0xffffffffu, 0xffffffffu, 1)), 0x1p52f);
}

TEST(Develop, alpha_and_cost_are_shares_of_the_samples) {
  std::vector<std::uint32_t> words = red_pixel(0, 0, 0, 4);
  words[FILM_HITS] = 3;
  words[FILM_RAYS] = 10;
  words[FILM_NODES] = 20;
  words[FILM_TRIANGLES] = 30;
  const DevelopedFilm film = develop(words, {0, 0, 1, 1});
  EXPECT_EQ(film.color[3], 0.75f);
  EXPECT_EQ(film.cost, (std::vector<float>{2.5f, 5.0f, 7.5f}));
  EXPECT_EQ(film.sample_count, (std::vector<std::uint32_t>{4}));
  EXPECT_EQ(film.least_samples, 4u);
  EXPECT_EQ(film.mean_samples, 4.0);
}

TEST(Develop, a_pixel_without_samples_is_black) {
  const DevelopedFilm film = develop(std::vector<std::uint32_t>(2 * FILM_WORDS), {0, 0, 2, 1});
  EXPECT_EQ(film.color, std::vector<float>(8));
  EXPECT_EQ(film.least_samples, 0u);
}

TEST(Develop, pixels_with_a_sample_that_is_not_finite_are_named) {
  std::vector<std::uint32_t> words;
  for (std::uint32_t pixel = 0; pixel < 6; ++pixel) {
    std::vector<std::uint32_t> one = red_pixel(0, 1u << 12, 0, 2);
    if (pixel >= 4) one[FILM_NON_FINITE] = 1;
    if (pixel >= 4) one[FILM_FIRST_NON_FINITE] = pixel + 3;
    words.insert(words.end(), one.begin(), one.end());
  }
  const DevelopedFilm film = develop(words, {100, 200, 3, 2});
  EXPECT_EQ(film.non_finite_pixels, 2u);
  EXPECT_EQ(film.first_non_finite.x, 101);
  EXPECT_EQ(film.first_non_finite.y, 201);
  EXPECT_EQ(film.first_non_finite.sample, 6u);
  EXPECT_TRUE(std::isnan(film.color[4 * 4]));
  EXPECT_FALSE(std::isnan(film.color[4 * 3]));
}

TEST(AovLayers, floats_and_ids_by_their_words) {
  std::vector<std::uint32_t> words(2 * AOV_WORDS);
  for (std::uint32_t i = 0; i < words.size(); ++i) words[i] = std::bit_cast<std::uint32_t>(static_cast<float>(i));
  DevelopedFilm developed;
  developed.sample_count = {3, 4};
  const std::vector<Layer> layers = aov_layers({"uv", "object_id", "sample_count"}, words, developed);
  ASSERT_EQ(layers.size(), 3u);
  EXPECT_EQ(layers[0].channels, (std::vector<std::string>{"U", "V"}));
  EXPECT_EQ(std::get<std::vector<float>>(layers[0].values),
            (std::vector<float>{AOV_UV, AOV_UV + 1.0f, AOV_WORDS + AOV_UV, AOV_WORDS + AOV_UV + 1.0f}));
  EXPECT_EQ(std::get<std::vector<std::uint32_t>>(layers[1].values)[1], words[AOV_WORDS + AOV_OBJECT_ID]);
  EXPECT_EQ(std::get<std::vector<std::uint32_t>>(layers[2].values), (std::vector<std::uint32_t>{3, 4}));
}

TEST(AovLayers, an_unknown_name_is_refused) {
  EXPECT_THROW(aov_layers({"colour"}, {}, {}), Error);
}

}  // namespace
}  // namespace vernier
