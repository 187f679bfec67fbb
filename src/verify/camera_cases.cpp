#include "verify/camera_cases.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "verify/function_kernel.h"
#include "verify/level_bound.h"
#include "verify/random.h"
#include "verify/tally.h"

namespace vernier {

CaseResult run_camera_edges(const CaseSetup& setup) {
  constexpr double kBound = 8.0;  // docstring
  std::vector<FunctionOperands> operands(setup.sample_count);
  for (std::uint64_t i = 0; i < setup.sample_count; ++i) {
    SampleRandom random(setup.seed, "camera_edges", i);
    const glm::dvec3 forward = random.direction();
    const glm::dvec3 right = glm::normalize(glm::cross(forward, random.direction()));
    const glm::dvec3 up = glm::cross(right, forward);
    const double degrees = i % 2 == 0 ? random.power_of_ten(-4.0, 2.0) : 180.0 - random.power_of_ten(-2.0, 2.0);
    const double t = std::tan(degrees * std::numbers::pi / 360.0);
    const float width = 1.0f + static_cast<float>(random.below(8192)),
                height = 1.0f + static_cast<float>(random.below(8192));
    FunctionOperands& o = operands[i];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const int k = static_cast<int>(axis);
      o[axis] = static_cast<float>(right[k] * t * width / height);
      o[axis + 3] = static_cast<float>(up[k] * t);
      o[axis + 6] = static_cast<float>(forward[k]);
    }
    o[9] = width;
    o[10] = height;
    o[11] = static_cast<float>(width * random.unit());
    o[12] = static_cast<float>(height * random.unit());
  }
  const auto answers = call_shader_function(setup, VERIFY_CAMERA, operands);
  Tally tally("half ulps of 1", level_bound(setup, kBound, kBound));
  for (std::size_t i = 0; i < operands.size(); ++i) {
    const FunctionOperands& o = operands[i];
    const glm::dvec3 right(o[0], o[1], o[2]), up(o[3], o[4], o[5]), forward(o[6], o[7], o[8]);
    const double nx = 2.0 * o[11] / o[9] - 1.0, ny = 1.0 - 2.0 * o[12] / o[10];
    const glm::dvec3 exact = glm::normalize(right * nx + up * ny + forward);
    double error = 0.0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double one = std::abs(static_cast<double>(answers[i][axis]) - exact[static_cast<int>(axis)]) / 0x1p-24;
      if (!(one <= error)) error = one;
    }
    tally.book_error(error, [&] {
      return hex_floats({{"up.x", o[3]},
                         {"up.y", o[4]},
                         {"up.z", o[5]},
                         {"width", o[9]},
                         {"height", o[10]},
                         {"x", o[11]},
                         {"y", o[12]}});
    });
  }
  return tally.result();
}

}  // namespace vernier
