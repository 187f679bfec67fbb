#include "verify/random.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vernier {
namespace {

TEST(SampleRandom, is_a_function_of_seed_case_and_sample) {
  SampleRandom a(1, "edge", 7), b(1, "edge", 7);
  for (int i = 0; i < 16; ++i) ASSERT_EQ(a.bits(), b.bits());
  const std::uint64_t first = SampleRandom(1, "edge", 7).bits();
  EXPECT_NE(SampleRandom(2, "edge", 7).bits(), first);
  EXPECT_NE(SampleRandom(1, "edges", 7).bits(), first);
  EXPECT_NE(SampleRandom(1, "edge", 8).bits(), first);
}

TEST(SampleRandom, samples_next_to_each_other_do_not_repeat_each_other) {
  // SplitMix64 with seeds one increment apart would give the same numbers one later.
  SampleRandom a(0, "x", 1);
  a.bits();
  EXPECT_NE(a.bits(), SampleRandom(0, "x", 2).bits());
}

TEST(SampleRandom, fills_its_ranges_evenly) {
  constexpr int kCount = 20000;
  double sum = 0.0;
  int hits[5] = {};
  SampleRandom random(3, "range", 0);
  for (int i = 0; i < kCount; ++i) {
    const double x = random.in(-2.0, 4.0);
    ASSERT_TRUE(x >= -2.0 && x < 4.0);
    sum += x;
    ++hits[random.below(5)];
    const double p = random.power_of_ten(-3.0, 2.0);
    ASSERT_TRUE(p >= 0.999e-3 && p < 100.1);
  }
  // Six standard deviations: of the mean of a uniform variable 6/sqrt(12 n), of a count sqrt(n 0.2 0.8).
  EXPECT_NEAR(sum / kCount, 1.0, 6 * 6.0 / std::sqrt(12.0 * kCount));
  for (const int count : hits) EXPECT_NEAR(count, kCount / 5, 6 * std::sqrt(kCount * 0.16));
}

TEST(SampleRandom, directions_are_unit_and_balanced) {
  constexpr int kCount = 20000;
  glm::dvec3 sum(0.0);
  SampleRandom random(4, "direction", 0);
  for (int i = 0; i < kCount; ++i) {
    const glm::dvec3 d = random.direction();
    ASSERT_NEAR(glm::length(d), 1.0, 1e-14) << "a few roundings of double";
    sum += d;
  }
  // The sum of n unit vectors has a length of about sqrt(n).
  EXPECT_LT(glm::length(sum), 6 * std::sqrt(kCount));
}

TEST(SampleRandom, steps_floats_either_way) {
  EXPECT_EQ(SampleRandom::stepped(1.0f, 0), 1.0f);
  EXPECT_EQ(SampleRandom::stepped(1.0f, 2), 1.0f + 0x1p-22f);
  EXPECT_EQ(SampleRandom::stepped(1.0f, -1), 1.0f - 0x1p-24f);
  EXPECT_EQ(SampleRandom::stepped(0.0f, -1), -0x1p-149f);
}

}  // namespace
}  // namespace vernier
