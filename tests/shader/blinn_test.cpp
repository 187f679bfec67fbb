#include <gtest/gtest.h>

#include <algorithm>

#include "shader/random_values.h"
#include "shader/shader.h"

namespace vernier::shader {
namespace {

using Extended = glm::tvec3<long double, glm::highp>;

long double dot(const Extended& a, const Extended& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

Extended unit(const Extended& v) {
  return v / std::sqrt(dot(v, v));
}

Extended extended(const vec3& v) {
  return {v.x, v.y, v.z};
}

/// (N.H)^e, H halfway between the two vectors as they are.
double exact_highlight(const vec3& normal, const Extended& half, long double exponent) {
  const long double cosine = dot(unit(extended(normal)), unit(half));
  if (cosine <= 0) return 0;
  return static_cast<double>(std::exp(exponent * std::log(std::min(cosine, 1.0L))));
}

TEST(Blinn, log_one_minus_is_good_to_its_last_digits) {
  RandomValues random(9);
  EXPECT_EQ(log_one_minus(0.0f), 0.0f);
  for (int i = 0; i < 200000; ++i) {
    const float s = (i & 1) != 0 ? random.in(0, 0.25) : std::min(random.power_of_ten(-30, 0), 0.2499f);
    const long double exact = std::log1p(-static_cast<long double>(s));
    ASSERT_NEAR(log_one_minus(s) / static_cast<double>(exact), 1.0, 6e-7) << s;
  }
}

TEST(Blinn, by_hand) {
  const vec3 up(0, 0, 1);
  EXPECT_EQ(blinn_highlight(up, up, up, 50.0f), 1.0f);
  EXPECT_EQ(blinn_highlight(up, vec3(1, 0, 0), vec3(-1, 0, 0), 1.0f), 0.0f);  // no half vector
  EXPECT_EQ(blinn_highlight(up, -up, vec3(1, 0, 0), 1.0f), 0.0f);
  EXPECT_EQ(blinn_highlight(up, vec3(1, 0, 0), vec3(0, 0, 1), 0.0f), 1.0f);
  EXPECT_EQ(blinn_highlight(up, -up, vec3(1, 0, 0), 0.0f), 0.0f);
  // Half way between x and z: cosine sqrt(1/2).
  EXPECT_NEAR(blinn_highlight(up, vec3(1, 0, 0), up, 1.0f), std::cos(0.125 * 6.283185307179586), 1e-7);
  EXPECT_NEAR(blinn_highlight(up, vec3(1, 0, 0), up, 2.0f), std::pow(std::cos(0.125 * 6.283185307179586), 2), 2e-7);
}

/// A normal and two unit vectors whose half vector lies within the lobe of the exponent, about exponent^(-1/2) wide.
struct Lobe {
  vec3 normal, light, viewer;
  float exponent;
};

Lobe random_lobe(RandomValues& random, double largest_power) {
  Lobe lobe;
  lobe.exponent = random.power_of_ten(0, largest_power);
  lobe.normal = unit_vector(random.direction());
  do lobe.viewer = unit_vector(random.direction());
  while (dot_product(lobe.normal, lobe.viewer) < 0.05f);
  const vec3 mirrored = lobe.normal * (2.0f * dot_product(lobe.normal, lobe.viewer)) - lobe.viewer;
  lobe.light = unit_vector(mirrored + random.direction() * (random.in(0, 4) / std::sqrt(lobe.exponent)));
  return lobe;
}

/// Largest error over lobes of exponents from 1 to 10^7, half of them at wide angles, of vectors as they are.
double worst_error() {
  RandomValues random(10);
  double worst = 0;
  for (int i = 0; i < 200000; ++i) {
    Lobe lobe = random_lobe(random, 7);
    if (i % 2 == 0) lobe.exponent = random.power_of_ten(0, 2);
    const double exact = exact_highlight(lobe.normal, extended(lobe.light) + extended(lobe.viewer), lobe.exponent);
    worst = std::max(worst, std::abs(blinn_highlight(lobe.normal, lobe.light, lobe.viewer, lobe.exponent) - exact));
  }
  return worst;
}

TEST(Blinn, reaches_the_numerics_targets_of_its_levels_at_any_exponent) {
  EXPECT_LE(worst_error(), 1e-6);
  LEVELS = LEVELS_OF(LEVEL_EXACT);
  EXPECT_LE(worst_error(), 1e-7);
  LEVELS = LEVELS_OF(LEVEL_FAST);
  EXPECT_GT(worst_error(), 0.1);
  LEVELS = LEVELS_OF(LEVEL_ROBUST);
}

TEST(ExactPower, is_right_to_a_place_or_two_of_1) {
  RandomValues random(12);
  for (int i = 0; i < 200000; ++i) {
    const float y = i % 3 == 0 ? -random.power_of_ten(-9, 1.9) : random.in(-5, 0);
    ASSERT_NEAR(wide_exp(widened(y)), std::exp(double(y)), 0x1p-24 + 0x1p-28) << y;
    const float m = i % 2 == 0 ? random.in(0, 1) : random.power_of_ten(-37, 0);
    const DoubleFloat log = wide_log(widened(m));
    ASSERT_NEAR((double(log.hi) + log.lo) / std::log(double(m)), 1.0, 3e-7) << m;
    const float s = random.in(0, 0.25);
    const DoubleFloat small = wide_log_one_minus(widened(s));
    // The series' rounding counts a fourth and less of the whole.
    ASSERT_NEAR((double(small.hi) + small.lo) / std::log1p(-double(s)), 1.0, 0x1p-24) << s;
  }
  EXPECT_EQ(wide_exp(widened(0.0f)), 1.0f);
  EXPECT_EQ(wide_exp(widened(-1e30f)), 0.0f);
  EXPECT_EQ(wide_exp(wide_log(widened(0.0f))), 0.0f);
}

}  // namespace
}  // namespace vernier::shader
