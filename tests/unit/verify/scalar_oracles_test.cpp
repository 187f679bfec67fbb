// Oracles of the scalar cases, values worked by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "shared/material_flags.h"
#include "verify/fresnel_oracle.h"
#include "verify/highlight_oracle.h"
#include "verify/light_oracle.h"
#include "verify/texture_oracle.h"

namespace vernier {
namespace {

using WideVector = glm::vec<3, long double>;

constexpr double kTiny = 1e-15;  // a few roundings of long double

TEST(FresnelOracle, straight_on_and_grazing) {
  // ((1.5 - 1) / (1.5 + 1))^2 = 1 / 25.
  EXPECT_NEAR(static_cast<double>(exact_fresnel(1.0f, 1.5f).reflected), 0.04, kTiny);
  EXPECT_NEAR(static_cast<double>(exact_fresnel(1.0f, 1.5f).transmitted), 0.96, kTiny);
  EXPECT_EQ(exact_fresnel(0.0f, 1.5f).reflected, 1.0L);
  EXPECT_EQ(exact_fresnel(0.0f, 1.5f).transmitted, 0.0L);
}

TEST(FresnelOracle, a_triangle_of_whole_numbers) {
  // cos = 3/5 in a medium of 4/3: sin behind is 3/5, cos behind 4/5. s: (3/5 - 16/15) / (3/5 + 16/15) = -7/25, p: 0.
  const ExactFresnel fresnel = exact_fresnel(0.6f, 4.0f / 3.0f);
  EXPECT_NEAR(static_cast<double>(fresnel.reflected), 0.5 * 0.28 * 0.28, 1e-7) << "0.6 and 4/3 are rounded";
  EXPECT_NEAR(static_cast<double>(fresnel.reflected + fresnel.transmitted), 1.0, kTiny);
}

TEST(FresnelOracle, total_reflection_begins_where_g_squared_is_0) {
  // eta = 1/2: sin^2 = 1/4 and more, cos^2 = 3/4 and less.
  EXPECT_EQ(exact_g_squared(1.0f, 0.5f), 0.25L);
  EXPECT_EQ(exact_g_squared(0.5f, 0.5f), -0.5L);
  EXPECT_TRUE(exact_fresnel(0.866f, 0.5f).total);
  EXPECT_FALSE(exact_fresnel(0.8661f, 0.5f).total);
  EXPECT_EQ(exact_fresnel(0.5f, 0.5f).reflected, 1.0L);
}

TEST(RefractionOracle, a_triangle_of_whole_numbers) {
  // As above: from sine 4/5 to sine 3/5, away from the side that the ray came from. Lengths do not count.
  const ExactRefraction behind =
      exact_refraction(WideVector(4.0L, 0.0L, 3.0L), WideVector(0.0L, 0.0L, 2.0L), 4.0L / 3.0L);
  EXPECT_FALSE(behind.total);
  EXPECT_NEAR(static_cast<double>(glm::length(behind.direction - WideVector(-0.6L, 0.0L, -0.8L))), 0.0, kTiny);
  EXPECT_NEAR(static_cast<double>(behind.cosine), 0.6, kTiny);
  EXPECT_NEAR(static_cast<double>(behind.refracted_cosine), 0.8, kTiny);
}

TEST(RefractionOracle, sees_total_reflection) {
  EXPECT_TRUE(exact_refraction(WideVector(0.8L, 0.0L, 0.6L), WideVector(0.0L, 0.0L, 1.0L), 0.75L).total);
  EXPECT_FALSE(exact_refraction(WideVector(0.6L, 0.0L, 0.8L), WideVector(0.0L, 0.0L, 1.0L), 0.75L).total);
}

TEST(RefractionOracle, condition_is_the_slope_of_the_direction) {
  // Straight through nothing is magnified. Out of glass of 4/3: c = 4/5, g = 3/4 3/5, sine 4/5.
  EXPECT_EQ(refraction_condition(exact_refraction({0.6L, 0.0L, 0.8L}, {0.0L, 0.0L, 1.0L}, 1.0L), 1.0L), 0.0L);
  const ExactRefraction out = exact_refraction({0.6L, 0.0L, 0.8L}, {0.0L, 0.0L, 1.0L}, 0.75L);
  EXPECT_NEAR(static_cast<double>(refraction_condition(out, 0.75L)), 0.8 * (0.8 - 0.45) / (0.45 * 0.75), kTiny);
}

TEST(HighlightOracle, is_a_power_of_the_cosine) {
  const WideVector light(0.0L, 0.6L, 0.8L), viewer(0.0L, -0.6L, 0.8L);
  EXPECT_EQ(exact_highlight({0.0L, 0.0L, 1.0L}, light, viewer, 1e7L), 1.0L);
  // Cosine 4/5: the normal's length does not count.
  EXPECT_NEAR(static_cast<double>(exact_highlight({6.0L, 0.0L, 8.0L}, light, viewer, 3.0L)), 0.512, kTiny);
  EXPECT_EQ(exact_highlight({6.0L, 0.0L, 8.0L}, light, viewer, 0.0L), 1.0L);
  EXPECT_EQ(exact_highlight({1.0L, 0.0L, 0.0L}, light, viewer, 0.0L), 0.0L) << "at right angles";
  EXPECT_EQ(exact_highlight({0.0L, 0.0L, -1.0L}, light, viewer, 1.0L), 0.0L);
}

TEST(HighlightOracle, keeps_the_digits_of_small_angles) {
  // (1 + 2^-40)^(-2^40 / 2): the angle's tangent is 2^-20. e^(-1/2) but for 2^-42.
  const WideVector light(0.0L, 0.6L, 0.8L), viewer(0.0L, -0.6L, 0.8L);
  const long double got = exact_highlight({0x1p-20L, 0.0L, 1.0L}, light, viewer, 0x1p40L);
  EXPECT_NEAR(static_cast<double>(got), std::exp(-0.5), 1e-12);
}

TEST(LightOracle, inverse_square_law_and_cone) {
  EXPECT_EQ(exact_attenuation({0.0L, 3.0L, 4.0L}), 0.04L);
  const WideVector down(0.0L, 0.0L, -1.0L);
  // Cosines 1/2 at the edge and 1 within: half way at 3/4, of which the square counts.
  EXPECT_EQ(exact_cone(down, 0.5L, 2.0L, {0.0L, 0.0L, -7.0L}), 1.0L);
  EXPECT_NEAR(static_cast<double>(exact_cone(down, 0.5L, 2.0L, {std::sqrt(7.0L), 0.0L, -3.0L})), 0.25, kTiny);
  EXPECT_EQ(exact_cone(down, 0.5L, 2.0L, {2.0L, 0.0L, -1.0L}), 0.0L);
  EXPECT_EQ(exact_cone(down, 0.5L, 1024.0L, {0.0L, 0.0L, -7.0L}), 1.0L) << "never more than all";
}

TEST(TextureOracle, wraps_a_place) {
  EXPECT_EQ(wrapped_place(-0.25L, TEXTURE_WRAP_REPEAT), 0.75L);
  EXPECT_EQ(wrapped_place(2.0L, TEXTURE_WRAP_REPEAT), 0.0L);
  EXPECT_EQ(wrapped_place(-0.25L, TEXTURE_WRAP_MIRROR), 0.25L);
  EXPECT_EQ(wrapped_place(1.25L, TEXTURE_WRAP_MIRROR), 0.75L);
  EXPECT_EQ(wrapped_place(-0.25L, TEXTURE_WRAP_CLAMP), 0.0L);
  EXPECT_EQ(wrapped_place(1.25L, TEXTURE_WRAP_CLAMP), 1.0L);
}

TEST(TextureOracle, finds_the_texel) {
  EXPECT_EQ(texel_of(0.0L, 4), 0);
  EXPECT_EQ(texel_of(0.25L, 4), 1);
  EXPECT_EQ(texel_of(wrapped_place(-1e-10L, TEXTURE_WRAP_REPEAT), 4), 3);
  EXPECT_EQ(texel_of(1.0L, 4), 3) << "belongs to the last";
}

TEST(TextureOracle, means_two_texels) {
  // Centres of four texels: 1/8, 3/8, 5/8, 7/8.
  EXPECT_EQ(exact_linear(0.375L, 4, TEXTURE_WRAP_CLAMP).value, 1.0L);
  EXPECT_EQ(exact_linear(0.5L, 4, TEXTURE_WRAP_CLAMP).value, 1.5L);
  EXPECT_EQ(exact_linear(0.0L, 4, TEXTURE_WRAP_CLAMP).value, 0.0L);
  EXPECT_EQ(exact_linear(0.0L, 4, TEXTURE_WRAP_MIRROR).value, 0.0L);
  EXPECT_EQ(exact_linear(0.0L, 4, TEXTURE_WRAP_REPEAT).value, 1.5L) << "of the last and the first";
  EXPECT_EQ(exact_linear(0.0L, 4, TEXTURE_WRAP_REPEAT).slope, 3.0L);
  EXPECT_EQ(exact_linear(0.5L, 4, TEXTURE_WRAP_CLAMP).slope, 1.0L);
  EXPECT_EQ(exact_linear(0.3L, 1, TEXTURE_WRAP_REPEAT).value, 0.0L);
}

}  // namespace
}  // namespace vernier
