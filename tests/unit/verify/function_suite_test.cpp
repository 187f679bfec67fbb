#include "verify/function_suite.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace vernier {
namespace {

TEST(OperandText, names_words_in_the_order_of_the_call) {
  const FunctionOperands o{0.5f, -1.0f, 2.0f, 1.0f, 0.0f, 0.0f, 1.5f};
  EXPECT_EQ(operand_text(VERIFY_REFRACTION, o),
            "to_viewer.x=0x1p-1 to_viewer.y=-0x1p+0 to_viewer.z=0x1p+1 normal.x=0x1p+0 normal.y=0x0p+0 "
            "normal.z=0x0p+0 eta=0x1.8p+0");
}

TEST(OperandText, knows_every_function) {
  for (std::uint32_t function = VERIFY_FRESNEL; function <= VERIFY_PLATE; ++function) {
    EXPECT_NE(operand_text(function, {}), "") << function;
  }
}

TEST(HalfUlpsApart, is_the_largest_difference_in_2_to_the_minus_24) {
  EXPECT_EQ(half_ulps_apart({1.0L, 0.0L, 0.5L}, {1.0L, 0x1p-23L, 0.5L - 0x1p-24L}), 2.0);
  EXPECT_EQ(half_ulps_apart({1.0L, 2.0L, 3.0L}, {1.0L, 2.0L, 3.0L}), 0.0);
}

TEST(HalfUlpsApart, keeps_nan_and_infinity_from_hiding) {
  const long double nan = std::numeric_limits<long double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(half_ulps_apart({nan, 0.0L, 0.0L}, {0.0L, 0.0L, 0.0L})));
  EXPECT_TRUE(std::isnan(half_ulps_apart({0.0L, 0.0L, nan}, {1.0L, 0.0L, 0.0L})));
  EXPECT_TRUE(
      std::isinf(half_ulps_apart({std::numeric_limits<long double>::infinity(), 0.0L, 0.0L}, {0.0L, 0.0L, 0.0L})));
}

TEST(PutVector, writes_and_reads_three_words) {
  FunctionOperands o{};
  put(o, 2, {0.5, -0.25, 8.0});
  EXPECT_EQ(wide_vector(o, 2), WideVector(0.5L, -0.25L, 8.0L));
  EXPECT_EQ(o[1], 0.0f);
  EXPECT_EQ(o[5], 0.0f);
}

}  // namespace
}  // namespace vernier
