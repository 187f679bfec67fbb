#include "verify/vector_cases.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "verify/function_suite.h"

namespace vernier {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// A device may take numbers below 2^-126 for 0: the vector with such components as they are, and as 0.
WideVector without_denormals(const WideVector& v) {
  WideVector kept = v;
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(v[axis]) < std::numeric_limits<float>::min()) kept[axis] = 0.0L;
  }
  return kept;
}

WideVector unit_or_zero(const WideVector& v) {
  const long double length = std::sqrt(glm::dot(v, v));
  return std::isfinite(length) && length > 0.0L ? v / length : WideVector(0.0L);
}

}  // namespace

CaseResult run_unit_vectors(const CaseSetup& setup) {
  constexpr float kHard[] = {0.0f,      -0.0f,     1e-30f, 1e30f, std::numeric_limits<float>::quiet_NaN(),
                             kInfinity, 0x1p-126f, 3e38f};
  return measured_calls(
      setup, "unit_vectors", VERIFY_UNIT_VECTOR, {"half ulps of 1", 4.0, 4.0},
      [&](SampleRandom& random, std::uint64_t i) {
        FunctionOperands o{};
        put(o, 0, random.direction() * random.power_of_ten(-37.0, 38.0));
        for (std::size_t axis = 0; axis < 3 && i % 8 == 0; ++axis) o[axis] = kHard[random.below(std::size(kHard))];
        return o;
      },
      [](const FunctionOperands& o, const FunctionAnswers& a) {
        const WideVector v = wide_vector(o, 0), got = wide_vector(a, 0);
        return std::min(half_ulps_apart(got, unit_or_zero(v)),
                        half_ulps_apart(got, unit_or_zero(without_denormals(v))));
      });
}

CaseResult run_shading_normal(const CaseSetup& setup) {
  constexpr float kHard[] = {0.0f, -0.0f, 1e-30f, 1e30f, -1e30f, 1.0f, -1.0f, kInfinity};
  return judged_calls(
      setup, "shading_normal", VERIFY_NORMAL,
      [&](SampleRandom& random, std::uint64_t i) {
        FunctionOperands o{};
        const glm::dvec3 normal = random.direction();
        for (std::size_t corner = 0; corner < 3; ++corner) {
          // Every other sample: corners that oppose one another, so that the sum may vanish.
          put(o, 3 * corner, i % 2 == 0 ? random.direction() : normal * (random.below(2) == 0 ? 1.0 : -1.0));
        }
        o[9] = static_cast<float>(random.below(4) * 0.25);
        o[10] = static_cast<float>((1.0 - o[9]) * (random.below(2) == 0 ? 0.5 : random.unit()));
        put(o, 11, random.direction());
        if (i % 4 == 1) {
          // Along axes: the sum may be at right angles to the geometric normal, without rounding.
          for (std::size_t word = 0; word < 9; ++word) o[word] = random.below(3) == 0 ? 1.0f : 0.0f;
          put(o, 11, {0.0, 0.0, random.below(2) == 0 ? 1.0 : -1.0});
        }
        if (i % 8 == 0) o[random.below(9)] = kHard[random.below(std::size(kHard))];
        return o;
      },
      [](const FunctionOperands& o, const FunctionAnswers& a) {
        const WideVector got = wide_vector(a, 0), geometric = wide_vector(o, 11);
        // 16 half ulps of 1: four of a unit vector's components each, and of their squares' sum twice as much. The
        // side is decided by a rounded cosine.
        const bool is_unit = std::abs(glm::length(got) - 1.0L) <= 16.0L * 0x1p-24L;
        return is_unit && glm::dot(got, geometric) >= -4.0L * 0x1p-24L;
      });
}

CaseResult run_frame(const CaseSetup& setup) {
  constexpr float kAxes[][3] = {{0, 0, -1}, {-0.0f, 0, -1}, {0, -0.0f, 1}, {1, -0.0f, 0}};
  return measured_calls(
      setup, "frame", VERIFY_FRAME, {"half ulps of 1", 8.0, 8.0},
      [&](SampleRandom& random, std::uint64_t i) {
        FunctionOperands o{};
        for (std::size_t k = 0; k < 12; ++k) o[k] = static_cast<float>(random.in(-1.0, 1.0));
        put(o, 12, random.direction());
        if (i % 16 == 0) std::ranges::copy(kAxes[i / 16 % std::size(kAxes)], o.begin() + 12);
        return o;
      },
      [](const FunctionOperands& o, const FunctionAnswers& a) -> double {
        const glm::dvec3 normal(o[12], o[13], o[14]), tangent(a[0], a[1], a[2]);
        const glm::dvec3 e1(o[6], o[7], o[8]), e2(o[9], o[10], o[11]);
        // The gradient cancels where UVs nearly coincide: its terms' size over its own is the condition.
        const glm::dvec3 gradient = e1 * static_cast<double>(o[5] - o[1]) - e2 * static_cast<double>(o[3] - o[1]);
        const glm::dvec3 flat = gradient - normal * glm::dot(normal, gradient);
        const double condition = glm::length(gradient) / glm::length(flat);
        const double skew = std::abs(glm::dot(normal, tangent)) / std::max(condition, 1.0);
        if (std::abs(a[3]) != 1.0f) return kInfinity;  // of no hand
        return std::max(skew, std::abs(glm::length(tangent) - 1.0)) / 0x1p-24;
      });
}

}  // namespace vernier
