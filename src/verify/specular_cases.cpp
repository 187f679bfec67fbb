#include "verify/specular_cases.h"

#include <algorithm>
#include <cmath>

#include "verify/function_kernel.h"
#include "verify/level_bound.h"
#include "verify/random.h"
#include "verify/tally.h"

namespace vernier {
namespace {

using WideVector = glm::vec<3, long double>;

constexpr double kRobust = 1e-6, kExact = 1e-7;  // numerics.md 5.3, absolute

std::string named(const FunctionOperands& o) {
  return hex_floats({{"normal.x", o[0]},
                     {"normal.y", o[1]},
                     {"normal.z", o[2]},
                     {"light.x", o[3]},
                     {"light.y", o[4]},
                     {"light.z", o[5]},
                     {"viewer.x", o[6]},
                     {"viewer.y", o[7]},
                     {"viewer.z", o[8]},
                     {"exponent", o[9]}});
}

void put(FunctionOperands& o, std::size_t first, const glm::dvec3& v) {
  for (std::size_t axis = 0; axis < 3; ++axis) o[first + axis] = static_cast<float>(v[static_cast<int>(axis)]);
}

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

/// The definition on the operands: cos^e by the logarithm of a cosine taken from the sine where it is
/// near 1, so that the oracle has no cancellation of its own.
long double exact_highlight(const FunctionOperands& o) {
  const WideVector n = glm::normalize(WideVector(o[0], o[1], o[2]));
  // L and V are unit to a rounding each, and the half vector is that of the two as they are: scaled to unit length
  // first, it would turn by that rounding, which the exponent 1e7 magnifies to 1e-4.
  const WideVector h = glm::normalize(WideVector(o[3], o[4], o[5]) + WideVector(o[6], o[7], o[8]));
  if (glm::dot(n, h) <= 0.0L) return 0.0L;
  const WideVector sine = glm::cross(n, h);
  return std::exp(0.5L * o[9] * std::log1p(-glm::dot(sine, sine)));
}

bool in_unit(float x) {
  return x >= 0.0f && x <= 1.0f;
}

}  // namespace

CaseResult run_extreme_exponent(const CaseSetup& setup) {
  std::vector<FunctionOperands> operands(setup.sample_count);
  for (std::uint64_t i = 0; i < setup.sample_count; ++i) {
    SampleRandom random(setup.seed, "extreme_exponent", i);
    const double exponent = random.power_of_ten(0.0, 7.0);
    // cos^e = exp(-e angle^2 / 2) falls from 1 to 1e-4 over this range.
    const double angle = std::min(random.unit() * std::sqrt(18.0 / exponent), 1.5);
    operands[i] = highlight(random, angle, static_cast<float>(exponent));
  }
  const auto answers = call_shader_function(setup, VERIFY_HIGHLIGHT, operands);
  Tally tally("absolute", level_bound(setup, kRobust, kExact));
  for (std::size_t i = 0; i < operands.size(); ++i) {
    const double error = std::abs(static_cast<double>(answers[i][0] - exact_highlight(operands[i])));
    tally.book_error(error, [&] { return named(operands[i]); });
  }
  return tally.result();
}

CaseResult run_highlight_limits(const CaseSetup& setup) {
  constexpr float kExponents[] = {0.0f, 1e-6f, 1.0f, 1e7f, 1e30f};
  // Half vector z; normals on it, across it (N.H = 0 and -0) and against it.
  constexpr float kNormals[][3] = {{0, 0, 1}, {1, 0, 0}, {1, 0, -0.0f}, {0, 0, -1}, {0.6f, 0, 0.8f}};
  std::vector<FunctionOperands> operands;
  for (const float exponent : kExponents) {
    for (const auto& normal : kNormals) {
      operands.push_back({normal[0], normal[1], normal[2], 0, 0.6f, 0.8f, 0, -0.6f, 0.8f, exponent});
    }
  }
  const auto answers = call_shader_function(setup, VERIFY_HIGHLIGHT, operands);
  Tally tally;
  for (std::size_t i = 0; i < operands.size(); ++i) {
    const FunctionOperands& o = operands[i];
    const float got = answers[i][0];
    bool held = in_unit(got);
    if (o[2] <= 0.0f) held = held && got == 0.0f;
    if (o[2] > 0.0f && o[9] == 0.0f) held = held && got == 1.0f;
    if (o[2] == 1.0f) held = held && got >= 1.0f - 0x1p-20f;  // N = H to the last place: only exp2's own rounding
    tally.book(held || setup.level == Accuracy::fast, [&] { return named(o); });
  }
  return tally.result();
}

CaseResult run_highlight_monotone(const CaseSetup& setup) {
  std::vector<FunctionOperands> operands(setup.sample_count / 2 * 2);
  for (std::uint64_t i = 0; i < operands.size(); i += 2) {
    SampleRandom random(setup.seed, "highlight_monotone", i);
    const double exponent = random.power_of_ten(0.0, 7.0);
    const double angle = std::min(random.unit() * std::sqrt(18.0 / exponent), 1.5);
    operands[i] = operands[i + 1] = highlight(random, angle, static_cast<float>(exponent));
    operands[i + 1][9] = static_cast<float>(exponent * (1.0 + random.power_of_ten(-6.0, 0.0)));
  }
  const auto answers = call_shader_function(setup, VERIFY_HIGHLIGHT, operands);
  Tally tally("absolute", level_bound(setup, kRobust, kExact));
  for (std::size_t i = 0; i < operands.size(); i += 2) {
    const double rise = static_cast<double>(answers[i + 1][0]) - static_cast<double>(answers[i][0]);
    tally.book_error(std::isfinite(rise) ? std::max(rise, 0.0) : rise, [&] { return named(operands[i + 1]); });
  }
  return tally.result();
}

CaseResult run_zero_half_vector(const CaseSetup& setup) {
  std::vector<FunctionOperands> operands(setup.sample_count);
  for (std::uint64_t i = 0; i < setup.sample_count; ++i) {
    SampleRandom random(setup.seed, "zero_half_vector", i);
    const glm::dvec3 light = random.direction();
    const double apart = i % 2 == 0 ? 0.0 : random.power_of_ten(-9.0, -7.0);
    FunctionOperands& o = operands[i];
    put(o, 0, random.direction());
    put(o, 3, light);
    put(o, 6, -light + random.direction() * apart);
    if (i % 2 == 0) put(o, 6, -glm::dvec3(o[3], o[4], o[5]));
    o[9] = static_cast<float>(random.power_of_ten(-6.0, 7.0));
  }
  const auto answers = call_shader_function(setup, VERIFY_HIGHLIGHT, operands);
  Tally tally;
  for (std::size_t i = 0; i < operands.size(); ++i) {
    const bool held = in_unit(answers[i][0]) && (i % 2 == 1 || answers[i][0] == 0.0f);
    tally.book(held || setup.level == Accuracy::fast, [&] { return named(operands[i]); });
  }
  return tally.result();
}

CaseResult run_log_one_minus(const CaseSetup& setup) {
  constexpr double kBound = 8.0;  // docstring
  std::vector<FunctionOperands> operands(setup.sample_count);
  for (std::uint64_t i = 0; i < setup.sample_count; ++i) {
    SampleRandom random(setup.seed, "log_one_minus", i);
    operands[i][0] = static_cast<float>(i % 2 == 0 ? random.power_of_ten(-36.0, -0.7) : random.in(0.0, 0.249));
  }
  const auto answers = call_shader_function(setup, VERIFY_LOG_ONE_MINUS, operands);
  Tally tally("ulp", level_bound(setup, kBound, kBound));
  for (std::size_t i = 0; i < operands.size(); ++i) {
    const float s = operands[i][0];
    const auto exact = static_cast<double>(std::log1p(-static_cast<long double>(s)));
    tally.book_error(ulps_from(answers[i][0], exact), [&] { return hex_floats({{"s", s}}); });
  }
  return tally.result();
}

CaseResult run_schlick_weight(const CaseSetup& setup) {
  constexpr double kBound = 9.0;  // docstring
  std::vector<FunctionOperands> operands(setup.sample_count);
  for (std::uint64_t i = 0; i < setup.sample_count; ++i) {
    SampleRandom random(setup.seed, "schlick_weight", i);
    operands[i][0] = static_cast<float>(i % 2 == 0 ? random.unit() : random.power_of_ten(-8.0, 0.0));
  }
  const auto answers = call_shader_function(setup, VERIFY_SCHLICK, operands);
  Tally tally("ulp", level_bound(setup, kBound, kBound));
  for (std::size_t i = 0; i < operands.size(); ++i) {
    const float cosine = operands[i][0];
    const auto exact = static_cast<double>(std::pow(1.0L - cosine, 5.0L));
    tally.book_error(ulps_from(answers[i][0], exact), [&] { return hex_floats({{"cosine", cosine}}); });
  }
  return tally.result();
}

}  // namespace vernier
