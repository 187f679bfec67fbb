#include "render/film_layer.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "shared/film_layout.h"

namespace vernier {
namespace {

std::vector<std::uint32_t> counted_words(std::size_t pixels) {
  std::vector<std::uint32_t> words(pixels * FILM_WORDS);
  for (std::size_t i = 0; i < words.size(); ++i) words[i] = static_cast<std::uint32_t>(i + 1);
  return words;
}

TEST(FilmLayer, GivesTheSumsBackFromChannelsInAnyOrder) {
  const std::vector<std::uint32_t> words = counted_words(2);
  Layer layer = film_layer(words);
  EXPECT_EQ(sums_of_layer(layer), words);
  std::ranges::reverse(layer.channels);
  auto& values = std::get<std::vector<std::uint32_t>>(layer.values);
  for (std::size_t pixel = 0; pixel < 2; ++pixel) {
    std::reverse(values.begin() + pixel * FILM_WORDS, values.begin() + (pixel + 1) * FILM_WORDS);
  }
  EXPECT_EQ(sums_of_layer(layer), words);
}

TEST(FilmLayer, OtherChannelsGiveNothing) {
  Layer layer = film_layer(counted_words(1));
  layer.channels[3] = "green";
  EXPECT_TRUE(sums_of_layer(layer).empty());
  EXPECT_TRUE(sums_of_layer({"film", {"hits"}, std::vector<std::uint32_t>{1}}).empty());
  EXPECT_TRUE(sums_of_layer({"film", layer.channels, std::vector<float>(FILM_WORDS)}).empty());
}

TEST(AddSums, CarriesFromWordToWord) {
  std::vector<std::uint32_t> sums(FILM_WORDS), more(FILM_WORDS);
  sums[FILM_GREEN] = 0xffffffffu;
  sums[FILM_GREEN + 1] = 0xffffffffu;
  sums[FILM_GREEN + 2] = 5;
  more[FILM_GREEN] = 2;
  add_sums(sums, more);
  EXPECT_EQ(sums[FILM_GREEN], 1u);
  EXPECT_EQ(sums[FILM_GREEN + 1], 0u);
  EXPECT_EQ(sums[FILM_GREEN + 2], 6u);
  EXPECT_EQ(sums[FILM_RED] + sums[FILM_BLUE], 0u);
}

TEST(AddSums, CostsEndAtTheLargestNumber) {
  std::vector<std::uint32_t> sums(FILM_WORDS), more(FILM_WORDS);
  sums[FILM_NODES] = 0xfffffff0u;
  more[FILM_NODES] = 0x10u;
  add_sums(sums, more);
  EXPECT_EQ(sums[FILM_NODES], 0xffffffffu);
}

TEST(AddSums, CountsAddUpAndTheFirstNonFiniteSampleStays) {
  std::vector<std::uint32_t> sums(FILM_WORDS, 3), more(FILM_WORDS, 4);
  add_sums(sums, more);
  for (const auto count : {FILM_HITS, FILM_SAMPLES, FILM_NON_FINITE, FILM_RAYS, FILM_NODES, FILM_TRIANGLES}) {
    EXPECT_EQ(sums[count], 7u) << count;
  }
  EXPECT_EQ(sums[FILM_FIRST_NON_FINITE], 3u);
  sums[FILM_FIRST_NON_FINITE] = 0;  // none
  add_sums(sums, more);
  EXPECT_EQ(sums[FILM_FIRST_NON_FINITE], 4u);
}

}  // namespace
}  // namespace vernier
