#include <gtest/gtest.h>

#include <algorithm>

#include "shader/random_values.h"
#include "shader/shader.h"

namespace vernier::shader {
namespace {

/// Reflectance by Fresnel's equations as in the textbooks, in extended precision; 1 beyond the critical angle.
long double textbook_reflectance(long double cosine, long double eta) {
  const long double sine_squared = (1 - cosine * cosine) / (eta * eta);
  if (sine_squared >= 1) return 1;
  const long double behind = std::sqrt(1 - sine_squared);
  const long double s = (cosine - eta * behind) / (cosine + eta * behind);
  const long double p = (eta * cosine - behind) / (eta * cosine + behind);
  return (s * s + p * p) / 2;
}

/// A cosine of incidence: half of them anywhere, half near grazing.
float random_cosine(RandomValues& random) {
  return random.word() % 2 == 0 ? random.in(0, 1) : std::min(random.power_of_ten(-8, 0), 1.0f);
}

/// Either ratio of an index that is `offset` above 1.
float random_ratio(RandomValues& random, float offset) {
  return random.word() % 2 == 0 ? 1.0f + offset : 1.0f / (1.0f + offset);
}

TEST(Fresnel, nothing_is_lost) {
  // From air against air to above diamond (2.42). The bound is the numerics target of the robust level.
  RandomValues random(6);
  for (int i = 0; i < 400000; ++i) {
    const float eta = random_ratio(random, i % 2 == 0 ? random.in(0, 3) : random.power_of_ten(-7, 0));
    const float cosine = random_cosine(random);
    const Fresnel fresnel = fresnel_dielectric(cosine, eta);
    ASSERT_LE(std::abs(double(fresnel.reflected) + fresnel.transmitted - 1), 1e-6) << cosine << ' ' << eta;
    ASSERT_GE(fresnel.reflected, 0.0f);
    ASSERT_GE(fresnel.transmitted, 0.0f);
  }
}

TEST(Fresnel, reflectance_is_the_textbook_s) {
  RandomValues random(7);
  for (int i = 0; i < 400000; ++i) {
    const float eta = random_ratio(random, i % 2 == 0 ? random.in(0, 3) : random.power_of_ten(-7, 0));
    const float cosine = random_cosine(random);
    const auto exact = static_cast<double>(textbook_reflectance(cosine, eta));
    ASSERT_NEAR(fresnel_dielectric(cosine, eta).reflected, exact, 2e-5) << cosine << ' ' << eta;
  }
}

TEST(Fresnel, next_to_the_critical_angle_no_digit_of_g_squared_is_lost) {
  // eta = 1/2, cosine^2 = 3/4 + 2^-24 or so: both squares have 48 bits, and their sum less 1 is exact in double.
  for (int steps = 1; steps < 100; ++steps) {
    float cosine = 0.8660254f;
    for (int i = 0; i < steps; ++i) cosine = std::nextafter(cosine, 1.0f);
    const double exact = (0.25 - 1) + double(cosine) * cosine;
    ASSERT_NEAR(narrowed(wide_g_squared(cosine, 0.5f)), exact, 0x1p-23 * exact);
  }
  EXPECT_EQ(narrowed(wide_g_squared(1.0f, 1e-3f)), 1e-3f * 1e-3f);
  EXPECT_EQ(narrowed(wide_g_squared(0.5f, 2.0f)), 3.25f);
}

TEST(Fresnel, by_hand) {
  const Fresnel straight = fresnel_dielectric(1.0f, 1.5f);
  EXPECT_NEAR(straight.reflected, 0.04, 1e-7);
  EXPECT_NEAR(straight.transmitted, 0.96, 1e-6);
  EXPECT_NEAR(straight.refracted_cosine, 1.5, 1e-6);
  // At Brewster's angle, tan = eta, only the s part is reflected: ((eta^2 - 1) / (eta^2 + 1))^2 / 2.
  const float brewster = 1.0f / std::sqrt(1.0f + 1.5f * 1.5f);
  EXPECT_NEAR(fresnel_dielectric(brewster, 1.5f).reflected, 0.5 * std::pow(1.25 / 3.25, 2), 1e-6);
  EXPECT_EQ(fresnel_dielectric(0.0f, 1.5f).reflected, 1.0f);
  EXPECT_EQ(fresnel_dielectric(0.0f, 1.5f).transmitted, 0.0f);
}

TEST(Fresnel, equal_indices_reflect_exactly_nothing) {
  for (float cosine : {1.0f, 0.5f, 1e-3f, 1e-8f}) {
    EXPECT_EQ(fresnel_dielectric(cosine, 1.0f).reflected, 0.0f);
    EXPECT_NEAR(fresnel_dielectric(cosine, 1.0f).transmitted, 1.0f, 2e-7);
  }
}

TEST(Fresnel, all_is_reflected_beyond_the_critical_angle) {
  const float critical = std::sqrt(1.0f - 1.0f / (1.5f * 1.5f));
  const Fresnel beyond = fresnel_dielectric(critical * 0.999f, 1.0f / 1.5f);
  EXPECT_EQ(beyond.reflected, 1.0f);
  EXPECT_EQ(beyond.transmitted, 0.0f);
  EXPECT_EQ(beyond.refracted_cosine, 0.0f);
  EXPECT_LT(fresnel_dielectric(critical * 1.001f, 1.0f / 1.5f).reflected, 1.0f);
}

TEST(Fresnel, schlick_weight_by_hand) {
  EXPECT_EQ(schlick_weight(1.0f), 0.0f);
  EXPECT_EQ(schlick_weight(0.0f), 1.0f);
  EXPECT_EQ(schlick_weight(0.5f), 0.03125f);
  EXPECT_EQ(schlick_weight(1.0001f), 0.0f);
}

}  // namespace
}  // namespace vernier::shader
