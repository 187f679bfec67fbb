#include "verify/light_cases.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "shared/light_kinds.h"
#include "verify/function_suite.h"
#include "verify/light_oracle.h"

namespace vernier {
namespace {

/// A light without range at `position`, and the point 0.
FunctionOperands light_at(const glm::dvec3& position, std::uint32_t kind, const glm::dvec3& direction) {
  FunctionOperands o{};
  put(o, 0, position);
  o[3] = static_cast<float>(kind);
  put(o, 4, direction);
  o[7] = std::numeric_limits<float>::infinity();
  o[8] = 1.0f;
  return o;
}

/// A unit vector at `angle` from `axis`.
glm::dvec3 turned(SampleRandom& random, const glm::dvec3& axis, double angle) {
  const glm::dvec3 aside = glm::normalize(glm::cross(axis, random.direction()));
  return axis * std::cos(angle) + aside * std::sin(angle);
}

}  // namespace

CaseResult run_hdr_light(const CaseSetup& setup) {
  constexpr long double kLargest = std::numeric_limits<float>::max(), kLeast = std::numeric_limits<float>::min();
  return measured_calls(
      setup, "hdr_light", VERIFY_LIGHT, {"relative", 1e-5, 1e-5},
      [](SampleRandom& random, std::uint64_t) {
        const glm::dvec3 place = random.direction() * random.power_of_ten(-10.0, 10.0);
        FunctionOperands o = light_at(place, LIGHT_POINT, {0.0, 0.0, -1.0});
        o[8] = static_cast<float>(random.power_of_ten(-30.0, 30.0));
        return o;
      },
      [&](const FunctionOperands& o, const FunctionAnswers& a) {
        const long double exact = o[8] * exact_attenuation(wide_vector(o, 0));
        // Beyond the range: infinity, or anything up to the smallest normal number.
        if (exact > kLargest) return a[3] >= std::numeric_limits<float>::max() ? 0.0 : 1.0;
        if (exact < kLeast) return a[3] >= 0.0f && a[3] <= 2.0f * kLeast ? 0.0 : 1.0;
        return static_cast<double>(std::abs(a[3] - exact) / exact);
      });
}

CaseResult run_spot_cone(const CaseSetup& setup) {
  constexpr double kLeastEdge = 1.0 / 1024.0;  // of the cosines, Image formation 5.4
  return measured_calls(
      setup, "spot_cone", VERIFY_LIGHT, {"half ulps of 1", 16.0, 16.0},
      [&](SampleRandom& random, std::uint64_t i) {
        const double outer = random.in(0.05, 1.5), inner = i % 4 == 0 ? outer : outer * random.unit();
        const glm::dvec3 direction = random.direction();
        // Half of the angles lie across the edge.
        const double angle = random.below(2) == 0 ? random.in(inner * 0.9, outer * 1.1) : random.in(0.0, 3.0);
        const glm::dvec3 to_point = turned(random, direction, angle) * random.power_of_ten(-3.0, 3.0);
        FunctionOperands o = light_at(-to_point, LIGHT_SPOT, direction);
        o[9] = static_cast<float>(std::cos(outer));
        o[10] = static_cast<float>(1.0 / std::max(std::cos(inner) - std::cos(outer), kLeastEdge));
        return o;
      },
      [](const FunctionOperands& o, const FunctionAnswers& a) {
        const WideVector offset = -wide_vector(o, 0);
        const long double exact = exact_cone(wide_vector(o, 4), o[9], o[10], offset);
        const long double apart = std::abs(a[3] / exact_attenuation(offset) - exact);
        return static_cast<double>(apart / (1.0L + o[10]) / 0x1p-24L);
      });
}

}  // namespace vernier
