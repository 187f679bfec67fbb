#include <gtest/gtest.h>

#include <limits>

#include "shader/random_values.h"
#include "shader/shader.h"

namespace vernier::shader {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

TEST(Rounding, gamma_bound_is_higham_s) {
  EXPECT_FLOAT_EQ(gamma_bound(1.0f), 0x1p-24f);
  EXPECT_GE(gamma_bound(3.0f), 3.0f * 0x1p-24f);
  EXPECT_NEAR(gamma_bound(1000.0f), 1000 * 0x1p-24 / (1 - 1000 * 0x1p-24), 1e-11);
}

TEST(Rounding, is_finite_judges_by_bits) {
  for (float x : {0.0f, -0.0f, 1.0f, LARGEST_FLOAT, -LARGEST_FLOAT, 1e-45f}) EXPECT_TRUE(is_finite(x)) << x;
  for (float x : {kInfinity, -kInfinity, kNan, -kNan}) EXPECT_FALSE(is_finite(x)) << x;
  EXPECT_TRUE(is_finite(vec3(1, 2, 3)));
  EXPECT_FALSE(is_finite(vec3(kNan, 2, 3)));
  EXPECT_FALSE(is_finite(vec3(1, kInfinity, 3)));
  EXPECT_FALSE(is_finite(vec3(1, 2, -kInfinity)));
}

TEST(Rounding, unit_vector_of_any_finite_length) {
  RandomValues random(1);
  for (int i = 0; i < 100000; ++i) {
    // Down to the smallest normal and up to the largest float.
    const vec3 v = random.direction() * random.power_of_ten(-36, 38);
    const glm::dvec3 exact = glm::normalize(glm::dvec3(v));
    // Roundings: three squares, two sums, root and reciprocal (each at most 1/2 ulp here) and the product: below 4 ulp
    // of 1.
    ASSERT_LT(glm::length(glm::dvec3(unit_vector(v)) - exact), 4 * 0x1p-24) << v.x << ' ' << v.y << ' ' << v.z;
  }
}

TEST(Rounding, unit_vector_does_not_change_with_a_power_of_two) {
  RandomValues random(2);
  for (int i = 0; i < 10000; ++i) {
    const vec3 v = random.direction();
    const vec3 u = unit_vector(v);
    for (float scale : {0x1p-100f, 0x1p-3f, 0x1p90f}) ASSERT_EQ(unit_vector(v * scale), u);
  }
}

TEST(Rounding, unit_vector_of_what_has_no_direction_is_zero) {
  EXPECT_EQ(unit_vector(vec3(0.0f)), vec3(0.0f));
  EXPECT_EQ(unit_vector(vec3(kNan)), vec3(0.0f));
  EXPECT_EQ(unit_vector(vec3(kNan, -0.0f, 1e38f)), vec3(0.0f));
  EXPECT_EQ(unit_vector(vec3(1, kInfinity, 0)), vec3(0.0f));
  EXPECT_EQ(unit_vector(vec3(0, 0, -LARGEST_FLOAT)), vec3(0, 0, -1));
  EXPECT_EQ(unit_vector(vec3(0x1p-126f, 0, 0)), vec3(1, 0, 0));
}

TEST(Rounding, products_by_hand) {
  EXPECT_EQ(dot_product(vec3(1, 2, 3), vec3(4, -5, 6)), 12.0f);
  EXPECT_EQ(cross_product(vec3(1, 0, 0), vec3(0, 1, 0)), vec3(0, 0, 1));
  EXPECT_EQ(cross_product(vec3(1, 2, 3), vec3(4, 5, 6)), vec3(-3, 6, -3));
  EXPECT_EQ(max3(vec3(1, 7, 3)), 7.0f);
  EXPECT_EQ(max3(vec3(-1, -7, -3)), -1.0f);
}

TEST(Rounding, of_two_numbers_the_second_stands_in_for_one_that_is_none) {
  EXPECT_EQ(smaller(1.0f, 2.0f), 1.0f);
  EXPECT_EQ(smaller(2.0f, -1.0f), -1.0f);
  EXPECT_EQ(larger(1.0f, 2.0f), 2.0f);
  EXPECT_EQ(larger(2.0f, -1.0f), 2.0f);
  EXPECT_EQ(smaller(kNan, 3.0f), 3.0f);
  EXPECT_EQ(larger(kNan, 3.0f), 3.0f);
}

}  // namespace
}  // namespace vernier::shader
