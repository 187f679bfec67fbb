#include <gtest/gtest.h>

#include <set>

#include "shader/shader.h"

namespace vernier::shader {
namespace {

/// shaders/README.md's definition: direction numbers v_1 = 2^31, v_(k+1) = v_k ^ (v_k >> 1).
std::uint32_t sobol_1_by_direction_numbers(std::uint32_t index) {
  std::uint32_t direction = 0x80000000u;
  std::uint32_t result = 0;
  for (int bit = 0; bit < 32; ++bit) {
    if ((index >> bit & 1u) != 0) result ^= direction;
    direction ^= direction >> 1;
  }
  return result;
}

TEST(SamplePattern, sobol_1_is_the_sum_of_its_direction_numbers) {
  for (std::uint32_t i = 0; i < 100000; ++i) ASSERT_EQ(sobol_1(i), sobol_1_by_direction_numbers(i));
  for (std::uint32_t i = 1; i < 100000; ++i) {
    ASSERT_EQ(sobol_1(i * 2654435761u), sobol_1_by_direction_numbers(i * 2654435761u));
  }
}

TEST(SamplePattern, the_hash_is_one_to_one_and_known) {
  EXPECT_EQ(hash_word(0u), 0u);
  // Worked through by hand with the five steps of shaders/README.md in Python.
  EXPECT_EQ(hash_word(1u), 1753845952u);
  std::set<std::uint32_t> seen;
  for (std::uint32_t i = 0; i < 100000; ++i) seen.insert(hash_word(i));
  EXPECT_EQ(seen.size(), 100000u);
}

TEST(SamplePattern, scrambling_keeps_the_structure_of_the_high_bits) {
  // Owen scrambling permutes each half within its half, and so on: the first k bits of the result depend on the first k
  // alone.
  for (std::uint32_t key : {0u, 1u, 0xdeadbeefu}) {
    for (std::uint32_t bits = 1; bits < 12; ++bits) {
      std::set<std::uint32_t> heads;
      for (std::uint32_t i = 0; i < 1u << bits; ++i) {
        const std::uint32_t head = owen_scramble(i << (32 - bits), key) >> (32 - bits);
        ASSERT_EQ(owen_scramble((i << (32 - bits)) | (0xffffffffu >> bits), key) >> (32 - bits), head);
        heads.insert(head);
      }
      ASSERT_EQ(heads.size(), std::size_t{1} << bits);
    }
  }
}

/// Whether the first 2^power samples of a pixel lie one each in all boxes of 2^-a by 2^-(power - a).
void expect_stratified(std::uint32_t x, std::uint32_t y, std::uint32_t seed, std::uint32_t power) {
  for (std::uint32_t a = 0; a <= power; ++a) {
    std::set<std::uint32_t> boxes;
    for (std::uint32_t s = 0; s < 1u << power; ++s) {
      const vec2 offset = sample_offset(x, y, s, seed, 1024u);
      ASSERT_GE(std::min(offset.x, offset.y), 0.0f);
      ASSERT_LT(std::max(offset.x, offset.y), 1.0f);
      const auto column = static_cast<std::uint32_t>(std::ldexp(offset.x, static_cast<int>(a)));
      const auto row = static_cast<std::uint32_t>(std::ldexp(offset.y, static_cast<int>(power - a)));
      boxes.insert(row << a | column);
    }
    ASSERT_EQ(boxes.size(), std::size_t{1} << power) << x << ' ' << y << ' ' << power << ' ' << a;
  }
}

TEST(SamplePattern, every_prefix_of_a_power_of_two_is_stratified) {
  for (std::uint32_t power = 0; power <= 10; ++power) {
    expect_stratified(0, 0, 0, power);
    expect_stratified(1919, 1079, 7, power);
    expect_stratified(65535, 3, 0xffffffffu, power);
  }
}

TEST(SamplePattern, one_sample_is_the_centre) {
  EXPECT_EQ(sample_offset(5u, 9u, 0u, 3u, 1u), vec2(0.5f));
}

TEST(SamplePattern, a_sample_depends_on_pixel_and_seed_and_not_on_their_number) {
  const vec2 offset = sample_offset(5u, 9u, 3u, 1u, 16u);
  EXPECT_EQ(sample_offset(5u, 9u, 3u, 1u, 64u), offset);
  EXPECT_NE(sample_offset(6u, 9u, 3u, 1u, 16u), offset);
  EXPECT_NE(sample_offset(5u, 10u, 3u, 1u, 16u), offset);
  EXPECT_NE(sample_offset(5u, 9u, 3u, 2u, 16u), offset);
}

TEST(SamplePattern, a_tent_has_half_a_square_s_area_left_of_each_place) {
  EXPECT_EQ(filtered_offset(vec2(0.25f, 0.75f), PIXEL_FILTER_BOX), vec2(0.25f, 0.75f));
  EXPECT_EQ(filtered_offset(vec2(0.0f, 0.5f), PIXEL_FILTER_TENT), vec2(-0.5f, 0.5f));
  for (std::uint32_t step = 0; step < 4096; ++step) {
    const float u = static_cast<float>(step) / 4096.0f;
    const double place = static_cast<double>(tent_place(u)) + 0.5;  // 0 to 2 over the tent
    const double area = place < 1.0 ? place * place / 2.0 : 1.0 - (2.0 - place) * (2.0 - place) / 2.0;
    // The root and two sums are rounded once each, at most half of 2^-23 below 2; the area has slope 1 at most.
    EXPECT_NEAR(area, static_cast<double>(u), 1.5 * 0x1p-23) << u;
  }
}

}  // namespace
}  // namespace vernier::shader
