#include <algorithm>
#include <cmath>

#include "verify/fresnel_cases.h"
#include "verify/function_kernel.h"
#include "verify/level_bound.h"
#include "verify/random.h"
#include "verify/tally.h"

namespace vernier {
namespace {

using WideVector = glm::vec<3, long double>;

constexpr double kHalfUlp = 0x1p-24;

std::string named(const FunctionOperands& o) {
  return hex_floats({{"viewer.x", o[0]},
                     {"viewer.y", o[1]},
                     {"viewer.z", o[2]},
                     {"normal.x", o[3]},
                     {"normal.y", o[4]},
                     {"normal.z", o[5]},
                     {"eta", o[6]}});
}

FunctionOperands directions(SampleRandom& random, float eta) {
  const glm::dvec3 normal = random.direction();
  glm::dvec3 viewer = random.direction();
  if (glm::dot(viewer, normal) < 0.0) viewer = -viewer;
  FunctionOperands o{};
  for (int axis = 0; axis < 3; ++axis) {
    o[static_cast<std::size_t>(axis)] = static_cast<float>(viewer[axis]);
    o[static_cast<std::size_t>(axis) + 3] = static_cast<float>(normal[axis]);
  }
  o[6] = eta;
  return o;
}

/// sin^2(theta_t) and, below 1, Snell's direction for the operands taken as they are but made unit.
long double snell(const FunctionOperands& o, WideVector& refracted) {
  const WideVector viewer = glm::normalize(WideVector(o[0], o[1], o[2]));
  const WideVector normal = glm::normalize(WideVector(o[3], o[4], o[5]));
  const long double eta = o[6];
  const WideVector along = (normal * glm::dot(viewer, normal) - viewer) / eta;
  const long double sine_squared = glm::dot(along, along);
  if (sine_squared < 1.0L) refracted = along - normal * std::sqrt(1.0L - sine_squared);
  return sine_squared;
}

double largest_difference(const FunctionAnswers& got, const WideVector& expected) {
  double largest = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    const double difference = std::abs(static_cast<double>(got[static_cast<std::size_t>(axis)] - expected[axis]));
    if (!(difference <= largest)) largest = difference;
  }
  return largest;
}

}  // namespace

CaseResult run_refracted_direction(const CaseSetup& setup) {
  constexpr double kRobust = 8.0, kExact = 4.0;  // docstring
  // 1 / cos(theta_t) is at most 4 there.
  constexpr long double kSteepest = 15.0L / 16.0L;
  std::vector<FunctionOperands> operands;
  for (std::uint64_t i = 0; i < setup.sample_count; ++i) {
    SampleRandom random(setup.seed, "refracted_direction", i);
    const double near_one = 1.0 + random.power_of_ten(-7.0, -2.0) * (random.below(2) == 0 ? 1.0 : -1.0);
    const double eta = random.below(2) == 0 ? near_one : std::exp2(random.in(-1.5, 1.5));
    const FunctionOperands o = directions(random, static_cast<float>(eta));
    WideVector unused;
    if (snell(o, unused) < kSteepest) operands.push_back(o);
  }
  const auto answers = call_shader_function(setup, VERIFY_REFRACTION, operands);
  Tally tally("half ulps of 1", level_bound(setup, kRobust, kExact));
  for (std::size_t i = 0; i < operands.size(); ++i) {
    WideVector expected;
    snell(operands[i], expected);
    tally.book_error(largest_difference(answers[i], expected) / kHalfUlp, [&] { return named(operands[i]); });
  }
  return tally.result();
}

CaseResult run_pass_through(const CaseSetup& setup) {
  constexpr double kBound = 4.0;  // docstring
  std::vector<FunctionOperands> operands(setup.sample_count);
  for (std::uint64_t i = 0; i < setup.sample_count; ++i) {
    SampleRandom random(setup.seed, "pass_through", i);
    operands[i] = directions(random, 1.0f);
  }
  const auto answers = call_shader_function(setup, VERIFY_REFRACTION, operands);
  Tally tally("half ulps of 1", level_bound(setup, kBound, kBound));
  for (std::size_t i = 0; i < operands.size(); ++i) {
    const FunctionOperands& o = operands[i];
    const WideVector straight = -glm::normalize(WideVector(o[0], o[1], o[2]));
    tally.book_error(largest_difference(answers[i], straight) / kHalfUlp, [&] { return named(o); });
  }
  return tally.result();
}

}  // namespace vernier
