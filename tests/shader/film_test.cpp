#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <limits>

#include "shader/random_values.h"
#include "shader/shader.h"

namespace vernier::shader {
namespace {

using Wide = unsigned __int128;

Wide whole(const WideSum& sum) {
  return (Wide(sum.high) << 64) | (Wide(sum.middle) << 32) | sum.low;
}

/// The sum of `values` in the order given.
Wide summed(const std::vector<float>& values) {
  WideSum sum(0u, 0u, 0u);
  for (float value : values) sum = wide_add(sum, fixed_point(value));
  return whole(sum);
}

TEST(Film, fixed_point_rounds_to_the_nearest_step) {
  RandomValues random(3);
  for (int i = 0; i < 200000; ++i) {
    const float value = std::bit_cast<float>(static_cast<std::uint32_t>(random.uniform(67, 159) * 0x1p23));
    // 24 bits times a power of two: exact in the 64 bits of a long double, and so is the half that is added.
    const auto expected = static_cast<Wide>(std::floor(std::ldexp(static_cast<long double>(value), 44) + 0.5L));
    ASSERT_TRUE(whole(fixed_point(value)) == expected) << value;
  }
}

TEST(Film, fixed_point_by_hand) {
  EXPECT_TRUE(whole(fixed_point(1.0f)) == Wide(1) << 44);
  EXPECT_TRUE(whole(fixed_point(1.5f)) == Wide(3) << 43);
  EXPECT_TRUE(whole(fixed_point(0x1p-44f)) == 1);
  EXPECT_TRUE(whole(fixed_point(0x1p-45f)) == 1);  // a tie goes up
  EXPECT_TRUE(whole(fixed_point(std::nextafter(0x1p-45f, 0.0f))) == 0);
  EXPECT_TRUE(whole(fixed_point(std::nextafter(0x1p32f, 0.0f))) == Wide(0xffffff) << (8 + 44));
}

TEST(Film, values_out_of_range_are_clamped) {
  const float huge = std::numeric_limits<float>::max();
  for (float value : {0.0f, -0.0f, -1.0f, -1e-30f, -huge, 1e-45f}) EXPECT_TRUE(whole(fixed_point(value)) == 0) << value;
  for (float value : {0x1p32f, 0x1.8p40f, huge}) EXPECT_TRUE(whole(fixed_point(value)) == Wide(1) << 76) << value;
}

TEST(Film, wide_add_carries_through_all_words) {
  RandomValues random(4);
  const WideSum ones(0xffffffffu, 0xffffffffu, 0u);
  EXPECT_TRUE(whole(wide_add(ones, WideSum(1u, 0u, 0u))) == Wide(1) << 64);
  EXPECT_TRUE(whole(wide_add(WideSum(0xffffffffu, 0u, 0u), WideSum(1u, 0xffffffffu, 0u))) == Wide(1) << 64);
  for (int i = 0; i < 100000; ++i) {
    // Words near the ends make carries likely.
    const auto word = [&] { return random.word() % 3 == 0 ? 0xffffffffu - random.word() % 2 : random.word(); };
    const WideSum a(word(), word(), word() >> 1);
    const WideSum b(word(), word(), word() >> 1);
    ASSERT_TRUE(whole(wide_add(a, b)) == whole(a) + whole(b));
  }
}

TEST(Film, a_sum_does_not_depend_on_the_order) {
  RandomValues random(5);
  std::vector<float> values;
  for (int i = 0; i < 5000; ++i) values.push_back(random.power_of_ten(-14, 9));
  const Wide sum = summed(values);
  for (int turn = 0; turn < 5; ++turn) {
    for (std::size_t i = values.size() - 1; i > 0; --i) std::swap(values[i], values[random.word() % (i + 1)]);
    ASSERT_TRUE(summed(values) == sum);
  }
}

TEST(Film, the_largest_samples_do_not_overflow) {
  WideSum sum(0u, 0u, 0u);
  const std::uint32_t count = 1u << 19;  // any more than 2^20 would
  for (std::uint32_t i = 0; i < count; ++i) sum = wide_add(sum, fixed_point(1e38f));
  EXPECT_TRUE(whole(sum) == Wide(count) << 76);
}

TEST(Film, samples_that_are_not_finite_are_counted_and_left_out) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  PixelSum sum{};
  add_sample(sum, vec3(1, 2, 3), true, 4u);
  add_sample(sum, vec3(nan, 2, 3), true, 9u);
  add_sample(sum, vec3(1, 2, std::numeric_limits<float>::infinity()), false, 7u);
  EXPECT_EQ(sum.samples, 3u);
  EXPECT_EQ(sum.hits, 2u);
  EXPECT_EQ(sum.non_finite, 2u);
  EXPECT_EQ(sum.first_non_finite, 8u);
  EXPECT_TRUE(whole(sum.red) == Wide(1) << 44);
  EXPECT_TRUE(whole(sum.blue) == Wide(3) << 44);
}

TEST(Film, a_pixel_comes_back_as_it_was_stored) {
  Memory words;
  words.film.assign(3 * FILM_WORDS, 0xabcdabcdu);
  const BoundMemory bound(words);
  const PixelSum sum = {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}, 10, 11, 12, 13, 14, 15, 16};
  store_pixel_sum(1u, sum);
  for (std::uint32_t i = 0; i < FILM_WORDS; ++i) {
    EXPECT_EQ(words.film[FILM_WORDS + i], i + 1);
    EXPECT_EQ(words.film[i], 0xabcdabcdu);
    EXPECT_EQ(words.film[2 * FILM_WORDS + i], 0xabcdabcdu);
  }
  const PixelSum back = load_pixel_sum(1u);
  EXPECT_TRUE(whole(back.green) == whole(sum.green));
  EXPECT_EQ(back.triangles, 16u);
  EXPECT_EQ(back.hits, 10u);
}

}  // namespace
}  // namespace vernier::shader
