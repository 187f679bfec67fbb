#include "verify/specular_cases.h"

#include <algorithm>
#include <cmath>

#include "verify/function_suite.h"
#include "verify/highlight_oracle.h"

namespace vernier {
namespace {

constexpr ErrorTarget kHighlight{"absolute", 1e-6, 1e-7};  // numerics.md 5.3

/// Normal, light and viewer with the half vector at `angle` from the normal.
FunctionOperands highlight(SampleRandom& random, double angle, float exponent) {
  const glm::dvec3 half = random.direction();
  const glm::dvec3 aside = glm::normalize(glm::cross(half, random.direction()));
  const glm::dvec3 across = glm::normalize(glm::cross(half, random.direction()));
  const double opening = random.in(0.0, 1.3);
  FunctionOperands o{};
  put(o, 0, half * std::cos(angle) + aside * std::sin(angle));
  put(o, 3, half * std::cos(opening) + across * std::sin(opening));
  put(o, 6, half * std::cos(opening) - across * std::sin(opening));
  o[9] = exponent;
  return o;
}

/// cos^e = exp(-e angle^2 / 2) falls from 1 to 1e-4 over the angles that are drawn.
FunctionOperands visible_highlight(SampleRandom& random, std::uint64_t) {
  const double exponent = random.power_of_ten(0.0, 7.0);
  const double angle = std::min(random.unit() * std::sqrt(18.0 / exponent), 1.5);
  return highlight(random, angle, static_cast<float>(exponent));
}

bool in_unit(float x) {
  return x >= 0.0f && x <= 1.0f;
}

}  // namespace

CaseResult run_extreme_exponent(const CaseSetup& setup) {
  return measured_calls(setup, "extreme_exponent", VERIFY_HIGHLIGHT, kHighlight, visible_highlight,
                        [](const FunctionOperands& o, const FunctionAnswers& a) {
                          const long double exact =
                              exact_highlight(wide_vector(o, 0), wide_vector(o, 3), wide_vector(o, 6), o[9]);
                          return std::abs(static_cast<double>(a[0] - exact));
                        });
}

CaseResult run_highlight_limits(const CaseSetup& setup) {
  constexpr float kExponents[] = {0.0f, 1e-6f, 1.0f, 1e7f, 1e30f};
  // Half vector z; normals on it, across it (N.H = 0 and -0) and against it.
  constexpr float kNormals[][3] = {{0, 0, 1}, {1, 0, 0}, {1, 0, -0.0f}, {0, 0, -1}, {0.6f, 0, 0.8f}};
  return judged_calls(
      setup, "highlight_limits", VERIFY_HIGHLIGHT,
      [&](SampleRandom&, std::uint64_t i) {
        const auto& normal = kNormals[i % std::size(kNormals)];
        const float exponent = kExponents[i / std::size(kNormals) % std::size(kExponents)];
        return FunctionOperands{normal[0], normal[1], normal[2], 0, 0.6f, 0.8f, 0, -0.6f, 0.8f, exponent};
      },
      [](const FunctionOperands& o, const FunctionAnswers& a) {
        bool held = in_unit(a[0]);
        if (o[2] <= 0.0f) held = held && a[0] == 0.0f;
        if (o[2] > 0.0f && o[9] == 0.0f) held = held && a[0] == 1.0f;
        if (o[2] == 1.0f) held = held && a[0] >= 1.0f - 0x1p-20f;  // N = H to the last place: only exp2's own rounding
        return held;
      });
}

CaseResult run_highlight_monotone(const CaseSetup& setup) {
  // Samples come in pairs, the second with a larger exponent: what it adds to the first is the error.
  float before = 0.0f;
  bool second = false;
  return measured_calls(
      setup, "highlight_monotone", VERIFY_HIGHLIGHT, kHighlight,
      [&](SampleRandom&, std::uint64_t i) {
        SampleRandom of_pair(setup.seed, "highlight_monotone", i / 2);
        FunctionOperands o = visible_highlight(of_pair, i);
        if (i % 2 == 1) o[9] = static_cast<float>(o[9] * (1.0 + of_pair.power_of_ten(-6.0, 0.0)));
        return o;
      },
      [&](const FunctionOperands&, const FunctionAnswers& a) {
        const double rise = second ? static_cast<double>(a[0]) - static_cast<double>(before) : 0.0;
        before = a[0];
        second = !second;
        return std::isfinite(rise) ? std::max(rise, 0.0) : rise;
      });
}

CaseResult run_zero_half_vector(const CaseSetup& setup) {
  return judged_calls(
      setup, "zero_half_vector", VERIFY_HIGHLIGHT,
      [](SampleRandom& random, std::uint64_t i) {
        const glm::dvec3 light = random.direction();
        FunctionOperands o{};
        put(o, 0, random.direction());
        put(o, 3, light);
        put(o, 6, -light + random.direction() * random.power_of_ten(-9.0, -7.0));
        if (i % 2 == 0) put(o, 6, -glm::dvec3(o[3], o[4], o[5]));
        o[9] = static_cast<float>(random.power_of_ten(-6.0, 7.0));
        return o;
      },
      [](const FunctionOperands& o, const FunctionAnswers& a) {
        const bool vanishes = wide_vector(o, 3) + wide_vector(o, 6) == WideVector(0.0L);
        return in_unit(a[0]) && (!vanishes || a[0] == 0.0f);
      });
}

CaseResult run_log_one_minus(const CaseSetup& setup) {
  return measured_calls(
      setup, "log_one_minus", VERIFY_LOG_ONE_MINUS, {"ulp", 8.0, 8.0},
      [](SampleRandom& random, std::uint64_t i) {
        return FunctionOperands{
            static_cast<float>(i % 2 == 0 ? random.power_of_ten(-36.0, -0.7) : random.in(0.0, 0.249))};
      },
      [](const FunctionOperands& o, const FunctionAnswers& a) {
        return ulps_from(a[0], static_cast<double>(std::log1p(-static_cast<long double>(o[0]))));
      });
}

CaseResult run_schlick_weight(const CaseSetup& setup) {
  return measured_calls(
      setup, "schlick_weight", VERIFY_SCHLICK, {"ulp", 9.0, 9.0},
      [](SampleRandom& random, std::uint64_t i) {
        return FunctionOperands{static_cast<float>(i % 2 == 0 ? random.unit() : random.power_of_ten(-8.0, 0.0))};
      },
      [](const FunctionOperands& o, const FunctionAnswers& a) {
        return ulps_from(a[0], static_cast<double>(std::pow(1.0L - o[0], 5.0L)));
      });
}

}  // namespace vernier
