#include "verify/tally.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "verify/run_cases.h"

namespace vernier {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

std::string never() {
  ADD_FAILURE() << "inputs were asked for";
  return "";
}

TEST(UlpsFrom, counts_in_spacings_at_the_expected_value) {
  EXPECT_EQ(ulps_from(1.0f, 1.0), 0.0);
  EXPECT_EQ(ulps_from(std::nextafter(1.0f, 2.0f), 1.0), 1.0);
  EXPECT_EQ(ulps_from(1.0f, 1.0 + 0x1p-24), 0.5);
  EXPECT_EQ(ulps_from(std::nextafter(1024.0f, 0.0f), 1024.0), 0.5) << "floats below a power of two are nearer";
  EXPECT_EQ(ulps_from(-2.0f, 2.0), 4.0 * 0x1p22);
}

TEST(UlpsFrom, zero_has_the_spacing_of_denormals) {
  EXPECT_EQ(ulps_from(-0.0f, 0.0), 0.0);
  EXPECT_EQ(ulps_from(0x1p-149f, 0.0), 1.0);
  EXPECT_EQ(ulps_from(0x1p-149f, 0x1p-140), 511.0);
}

TEST(UlpsFrom, what_is_not_finite_is_right_or_infinitely_far) {
  EXPECT_EQ(ulps_from(kNan, std::nan("")), 0.0);
  EXPECT_EQ(ulps_from(kNan, 1.0), kInfinity);
  EXPECT_EQ(ulps_from(INFINITY, kInfinity), 0.0);
  EXPECT_EQ(ulps_from(INFINITY, 1e300), 0.0) << "rounds to infinity";
  EXPECT_EQ(ulps_from(INFINITY, -kInfinity), kInfinity);
}

TEST(HexFloats, are_exact_and_named) {
  EXPECT_EQ(hex_floats({{"a", 1.5f}, {"b", -0.0f}}), "a=0x1.8p+0 b=-0x0p+0");
}

TEST(Tally, counts_failures_and_keeps_the_first) {
  Tally tally;
  tally.book(true, never);
  tally.book(false, [] { return std::string("first"); });
  tally.book(false, never);
  const CaseResult result = tally.result();
  EXPECT_EQ(result.samples, 3u);
  EXPECT_EQ(result.failures, 2u);
  EXPECT_EQ(result.first_failure, 1u);
  EXPECT_EQ(result.worst_inputs, "first");
  EXPECT_FALSE(result.has_errors);
}

TEST(Tally, tells_quantiles_and_the_largest_error) {
  Tally tally("ulp", 1000.0);
  for (int i = 100; i >= 0; --i) tally.book_error(i, [i] { return std::to_string(i); });
  const CaseResult result = tally.result();
  EXPECT_TRUE(result.has_errors);
  EXPECT_EQ(result.failures, 0u);
  EXPECT_EQ(result.p50, 50.0);
  EXPECT_EQ(result.p99, 99.0);
  EXPECT_EQ(result.max, 100.0);
  EXPECT_EQ(result.worst_inputs, "100");
}

TEST(Tally, an_error_above_the_bound_fails_and_one_at_it_does_not) {
  Tally tally("ulp", 2.0);
  tally.book_error(2.0, [] { return std::string("at"); });
  EXPECT_EQ(tally.result().failures, 0u);
  tally.book_error(2.5, [] { return std::string("above"); });
  EXPECT_EQ(tally.result().failures, 1u);
  EXPECT_EQ(tally.result().worst_inputs, "above");
}

TEST(Tally, what_is_not_finite_fails_even_without_a_bound) {
  Tally tally("ulp", kInfinity);
  tally.book_error(std::nan(""), [] { return std::string("nan"); });
  tally.book_error(kInfinity, never);
  const CaseResult result = tally.result();
  EXPECT_EQ(result.non_finite, 2u);
  EXPECT_EQ(result.failures, 2u);
  EXPECT_EQ(result.max, 0.0);
}

TEST(Tally, root_mean_square_of_the_errors) {
  Tally tally("ulp", kInfinity);
  for (const double error : {3.0, 4.0, 0.0, 0.0}) tally.book_error(error, [] { return std::string(); });
  EXPECT_DOUBLE_EQ(tally.result().rms, 2.5);  // sqrt(25 / 4)
}

TEST(RateBound, is_the_rule_of_three) {
  EXPECT_EQ(rate_bound(0), 1.0);
  EXPECT_EQ(rate_bound(2), 1.0);
  EXPECT_DOUBLE_EQ(rate_bound(3000000), 1e-6);
}

}  // namespace
}  // namespace vernier
