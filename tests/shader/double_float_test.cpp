#include <gtest/gtest.h>

#include <cmath>

#include "shader/random_values.h"
#include "shader/shader.h"

namespace vernier::shader {
namespace {

using Wide = __float128;

constexpr int kCount = 200000;
// Squared half ulp of 1: the unit of the bounds of double_float.glsl.
constexpr double kSquaredUnit = 0x1p-48;

Wide value_of(const DoubleFloat& x) {
  return Wide(x.hi) + Wide(x.lo);
}

double size_of(Wide x) {
  return std::abs(static_cast<double>(x));
}

/// Error relative to the exact value, in squared units.
double relative_error(const DoubleFloat& found, Wide exact) {
  return exact == 0 ? size_of(value_of(found)) : size_of((value_of(found) - exact) / exact) / kSquaredUnit;
}

float any_float(RandomValues& random) {
  return (random.word() & 1u ? 1.0f : -1.0f) * random.power_of_ten(-6, 6);
}

DoubleFloat any_wide(RandomValues& random) {
  const float hi = any_float(random);
  return fast_two_sum(hi, hi * random.in(-0x1p-25, 0x1p-25));
}

TEST(DoubleFloat, sums_and_products_of_two_floats_are_exact) {
  RandomValues random(1);
  for (int i = 0; i < kCount; ++i) {
    const float a = any_float(random), b = any_float(random);
    ASSERT_TRUE(value_of(two_sum(a, b)) == Wide(a) + Wide(b)) << a << " " << b;
    ASSERT_TRUE(value_of(two_difference(a, b)) == Wide(a) - Wide(b)) << a << " " << b;
    ASSERT_TRUE(value_of(two_product(a, b)) == Wide(a) * Wide(b)) << a << " " << b;
    ASSERT_EQ(two_sum(a, b).hi, a + b);
    ASSERT_EQ(two_product(a, b).hi, a * b);
  }
}

TEST(DoubleFloat, wide_operations_keep_their_bounds) {
  RandomValues random(2);
  double product = 0, quotient = 0, root = 0, sum = 0, difference = 0;
  for (int i = 0; i < kCount; ++i) {
    const DoubleFloat a = any_wide(random), b = any_wide(random);
    const Wide x = value_of(a), y = value_of(b);
    product = std::max(product, relative_error(wide_product(a, b), x * y));
    quotient = std::max(quotient, relative_error(wide_quotient(a, b), x / y));
    sum = std::max(sum, relative_error(wide_sum(a, b), x + y));
    difference = std::max(difference, relative_error(wide_difference(a, b), x - y));
    const DoubleFloat positive(std::abs(a.hi), a.hi < 0 ? -a.lo : a.lo);
    const DoubleFloat r = wide_square_root(positive);
    // (r^2 - a) / a is twice the relative error of r.
    root =
        std::max(root, 0.5 * relative_error(DoubleFloat(1.0f, 0.0f), value_of(r) * value_of(r) / value_of(positive)));
  }
  EXPECT_LE(sum, 3.0 * (1 + 0x1p-20));
  EXPECT_LE(difference, 3.0 * (1 + 0x1p-20));
  EXPECT_LE(product, 5.0);
  EXPECT_LE(quotient, 15.0);
  // A Newton step squares the relative error of the float's root, at most 2.5 ulps by the Vulkan specification: 12.5
  // squared units, and the correction's own rounding adds 2.
  EXPECT_LE(root, 15.0);
  EXPECT_GT(product, 0.5);  // the measure measures
}

TEST(DoubleFloat, differences_of_products_have_the_right_sign) {
  RandomValues random(3);
  int close = 0;
  for (int i = 0; i < kCount; ++i) {
    const float a = any_float(random), b = any_float(random), c = any_float(random);
    // d as close to a b / c as floats go: the products agree in their leading bits.
    float d = static_cast<float>(double(a) * double(b) / double(c));
    for (int step = static_cast<int>(random.word() % 3); step > 0; --step) d = std::nextafter(d, INFINITY);
    const double exact = double(a) * double(b) - double(c) * double(d);  // exact: 48 bits each, nearly equal
    const float found = signed_difference_of_products(a, b, c, d);
    ASSERT_EQ(exact > 0, found > 0) << a << " " << b << " " << c << " " << d;
    ASSERT_EQ(exact < 0, found < 0) << a << " " << b << " " << c << " " << d;
    const float sign = sign_of_difference(a, b, c, d);
    ASSERT_EQ(exact > 0, sign > 0) << a << " " << b << " " << c << " " << d;
    ASSERT_EQ(exact < 0, sign < 0) << a << " " << b << " " << c << " " << d;
    close += a * b == c * d && exact != 0 ? 1 : 0;
  }
  EXPECT_GT(close, kCount / 100);  // where rounding alone would answer 0
}

}  // namespace
}  // namespace vernier::shader
