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
    const float s = (i & 1) != 0 ? random.in(0, 1) : std::min(random.power_of_ten(-30, 0), 0.9999f);
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

TEST(Blinn, the_power_is_exact_for_any_half_vector) {
  RandomValues random(10);
  double worst = 0;
  for (int i = 0; i < 200000; ++i) {
    const Lobe lobe = random_lobe(random, 7);
    // Light and viewer in one place: the half vector is that direction, and nothing is lost on the way to it.
    const vec3 half = unit_vector(lobe.light + lobe.viewer);
    const vec3 again = unit_vector(half + half);
    const double exact = exact_highlight(lobe.normal, extended(again), lobe.exponent);
    worst = std::max(worst, std::abs(blinn_highlight(lobe.normal, half, half, lobe.exponent) - exact));
  }
  EXPECT_LE(worst, 1e-6);  // numerics target of the robust level
}

TEST(Blinn, a_half_vector_rounded_to_floats_moves_a_sharp_highlight_no_further_than_it_must) {
  // H is off by up to 3 half ulps of 1 across (sum, two roundings of unit_vector); the lobe's steepest slope is
  // sqrt(exponent / e): at most 2^-24 3 sqrt(3) sqrt(exponent / e) and the target above.
  RandomValues random(11);
  for (int i = 0; i < 200000; ++i) {
    const Lobe lobe = random_lobe(random, 7);
    const double exact = exact_highlight(lobe.normal, extended(lobe.light) + extended(lobe.viewer), lobe.exponent);
    const double bound = 1e-6 + 0x1p-24 * 3 * std::sqrt(3.0 * lobe.exponent / 2.718281828459045);
    ASSERT_NEAR(blinn_highlight(lobe.normal, lobe.light, lobe.viewer, lobe.exponent), exact, bound) << lobe.exponent;
  }
}

}  // namespace
}  // namespace vernier::shader
