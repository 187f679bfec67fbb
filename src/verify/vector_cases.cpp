#include "verify/vector_cases.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "verify/function_kernel.h"
#include "verify/level_bound.h"
#include "verify/random.h"
#include "verify/tally.h"

namespace vernier {
namespace {

using WideVector = glm::vec<3, long double>;

constexpr double kHalfUlp = 0x1p-24;

}  // namespace

CaseResult run_unit_vectors(const CaseSetup& setup) {
  constexpr double kBound = 4.0;  // docstring
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  constexpr float kHard[] = {0.0f,      -0.0f, 1e-30f, 1e30f, kNan, std::numeric_limits<float>::infinity(),
                             0x1p-126f, 3e38f};
  std::vector<FunctionOperands> operands(setup.sample_count);
  for (std::uint64_t i = 0; i < setup.sample_count; ++i) {
    SampleRandom random(setup.seed, "unit_vectors", i);
    const glm::dvec3 v = random.direction() * random.power_of_ten(-37.0, 38.0);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      operands[i][axis] =
          i % 8 == 0 ? kHard[random.below(std::size(kHard))] : static_cast<float>(v[static_cast<int>(axis)]);
    }
  }
  const auto answers = call_shader_function(setup, VERIFY_UNIT_VECTOR, operands);
  Tally tally("half ulps of 1", level_bound(setup, kBound, kBound));
  for (std::size_t i = 0; i < operands.size(); ++i) {
    const FunctionOperands& o = operands[i];
    const WideVector v(o[0], o[1], o[2]);
    const long double length = std::sqrt(glm::dot(v, v));
    const bool defined = std::isfinite(length) && length > 0.0L;
    double error = 0.0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const long double expected = defined ? o[axis] / length : 0.0L;
      const double one = static_cast<double>(std::abs(answers[i][axis] - expected)) / kHalfUlp;
      if (!(one <= error)) error = one;
    }
    tally.book_error(error, [&] { return hex_floats({{"v.x", o[0]}, {"v.y", o[1]}, {"v.z", o[2]}}); });
  }
  return tally.result();
}

CaseResult run_frame(const CaseSetup& setup) {
  constexpr double kBound = 8.0;  // docstring
  constexpr float kAxes[][3] = {{0, 0, -1}, {-0.0f, 0, -1}, {0, -0.0f, 1}, {1, -0.0f, 0}};
  std::vector<FunctionOperands> operands(setup.sample_count);
  for (std::uint64_t i = 0; i < setup.sample_count; ++i) {
    SampleRandom random(setup.seed, "frame", i);
    FunctionOperands& o = operands[i];
    for (std::size_t k = 0; k < 6; ++k) o[k] = static_cast<float>(random.in(-1.0, 1.0));
    for (std::size_t k = 6; k < 12; ++k) o[k] = static_cast<float>(random.in(-1.0, 1.0));
    const glm::dvec3 normal = random.direction();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      o[12 + axis] =
          i % 16 == 0 ? kAxes[i / 16 % std::size(kAxes)][axis] : static_cast<float>(normal[static_cast<int>(axis)]);
    }
  }
  const auto answers = call_shader_function(setup, VERIFY_FRAME, operands);
  Tally tally("half ulps of 1", level_bound(setup, kBound, kBound));
  for (std::size_t i = 0; i < operands.size(); ++i) {
    const FunctionOperands& o = operands[i];
    const FunctionAnswers& a = answers[i];
    const glm::dvec3 normal(o[12], o[13], o[14]), tangent(a[0], a[1], a[2]);
    const glm::dvec3 e1(o[6], o[7], o[8]), e2(o[9], o[10], o[11]);
    // The gradient cancels where UVs nearly coincide: its terms' size over its own is the condition.
    const glm::dvec3 gradient = e1 * static_cast<double>(o[5] - o[1]) - e2 * static_cast<double>(o[3] - o[1]);
    const glm::dvec3 flat = gradient - normal * glm::dot(normal, gradient);
    const double condition = glm::length(gradient) / glm::length(flat);
    const double skew = std::abs(glm::dot(normal, tangent)) / std::max(condition, 1.0);
    const double error = std::max(skew, std::abs(glm::length(tangent) - 1.0)) / kHalfUlp;
    const bool handed = std::abs(a[3]) == 1.0f;
    tally.book_error(handed ? error : std::numeric_limits<double>::infinity(), [&] {
      return hex_floats({{"uv0.u", o[0]},
                         {"uv0.v", o[1]},
                         {"uv1.u", o[2]},
                         {"uv1.v", o[3]},
                         {"uv2.u", o[4]},
                         {"uv2.v", o[5]},
                         {"e1.x", o[6]},
                         {"e1.y", o[7]},
                         {"e1.z", o[8]},
                         {"e2.x", o[9]},
                         {"e2.y", o[10]},
                         {"e2.z", o[11]},
                         {"normal.x", o[12]},
                         {"normal.y", o[13]},
                         {"normal.z", o[14]}});
    });
  }
  return tally.result();
}

}  // namespace vernier
