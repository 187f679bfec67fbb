#include "verify/refraction_cases.h"

#include <algorithm>
#include <cmath>

#include "verify/fresnel_oracle.h"
#include "verify/function_suite.h"

namespace vernier {
namespace {

FunctionOperands boundary(const glm::dvec3& to_viewer, const glm::dvec3& normal, double eta) {
  FunctionOperands o{};
  put(o, 0, to_viewer);
  put(o, 3, normal);
  o[6] = static_cast<float>(eta);
  return o;
}

FunctionOperands any_boundary(SampleRandom& random, double eta) {
  const glm::dvec3 normal = random.direction(), viewer = random.direction();
  return boundary(glm::dot(viewer, normal) < 0.0 ? -viewer : viewer, normal, eta);
}

ExactRefraction snell(const FunctionOperands& o) {
  return exact_refraction(wide_vector(o, 0), wide_vector(o, 3), o[6]);
}

/// A ray that falls on a plate of glass at 2^-7 above the surface or steeper.
FunctionOperands onto_plate(SampleRandom& random, std::uint64_t) {
  const glm::dvec3 normal = random.direction();
  const glm::dvec3 along = glm::normalize(glm::cross(normal, random.direction()));
  const double cosine = std::exp2(random.in(-7.0, 0.0)), sine = std::sqrt((1.0 - cosine) * (1.0 + cosine));
  return boundary(normal * cosine + along * sine, normal, random.in(1.01, 3.0));
}

}  // namespace

CaseResult run_refracted_direction(const CaseSetup& setup) {
  // sin^2 = 15/16: the cosine behind is 1/4 there.
  constexpr long double kFlattest = 0.25L;
  return measured_calls(
      setup, "refracted_direction", VERIFY_REFRACTION, {"half ulps of 1", 8.0, 1.0},
      [&](SampleRandom& random, std::uint64_t) {
        FunctionOperands o;
        do {
          const double near_one = 1.0 + random.power_of_ten(-7.0, -2.0) * (random.below(2) == 0 ? 1.0 : -1.0);
          o = any_boundary(random, random.below(2) == 0 ? near_one : std::exp2(random.in(-1.5, 1.5)));
        } while (snell(o).refracted_cosine <= kFlattest);
        return o;
      },
      [&](const FunctionOperands& o, const FunctionAnswers& a) {
        const ExactRefraction exact = snell(o);
        const long double condition = refraction_condition(exact, o[6]);
        const double allowance = setup.level == Accuracy::exact ? 1.0 : static_cast<double>(1.0L + condition);
        return half_ulps_apart(wide_vector(a, 0), exact.direction) / allowance;
      });
}

CaseResult run_pass_through(const CaseSetup& setup) {
  return measured_calls(
      setup, "pass_through", VERIFY_REFRACTION, {"half ulps of 1", 4.0, 1.0},
      [](SampleRandom& random, std::uint64_t) { return any_boundary(random, 1.0); },
      [](const FunctionOperands& o, const FunctionAnswers& a) {
        return half_ulps_apart(wide_vector(a, 0), -glm::normalize(wide_vector(o, 0)));
      });
}

CaseResult run_plate_exit(const CaseSetup& setup) {
  const bool exact = setup.level == Accuracy::exact;
  return measured_calls(setup, "plate_exit", VERIFY_PLATE, {"half ulps of 1", 8.0, 8.0}, onto_plate,
                        [&](const FunctionOperands& o, const FunctionAnswers& a) {
                          const ExactRefraction in = snell(o);
                          const ExactRefraction out{false, {}, in.refracted_cosine, in.cosine};
                          const long double growth = o[6] * in.refracted_cosine / in.cosine;
                          const long double condition = exact ? 0.0L : refraction_condition(out, 1.0L / o[6]);
                          const double apart = half_ulps_apart(wide_vector(a, 3), -glm::normalize(wide_vector(o, 0)));
                          return apart / static_cast<double>(std::max({1.0L, growth, condition}));
                        });
}

CaseResult run_plate_shift(const CaseSetup& setup) {
  return measured_calls(setup, "plate_shift", VERIFY_PLATE, {"half ulps of 1", 8.0, 8.0}, onto_plate,
                        [](const FunctionOperands& o, const FunctionAnswers& a) {
                          const ExactRefraction inside = snell(o);
                          const WideVector in = -glm::normalize(wide_vector(o, 0)),
                                           normal = glm::normalize(wide_vector(o, 3));
                          // Where the ray meets the other face, and how far that is off the line of the ray as it came.
                          const WideVector way = wide_vector(a, 0) / -glm::dot(wide_vector(a, 0), normal);
                          const long double shift = glm::length(way - in * glm::dot(way, in));
                          const long double sine = std::sqrt((1.0L - inside.cosine) * (1.0L + inside.cosine));
                          const long double exact = sine * (1.0L - inside.cosine / (o[6] * inside.refracted_cosine));
                          return static_cast<double>(std::abs(shift - exact) * inside.refracted_cosine / 0x1p-24L);
                        });
}

}  // namespace vernier
