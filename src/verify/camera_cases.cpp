#include "verify/camera_cases.h"

#include <cmath>
#include <numbers>

#include "verify/function_suite.h"

namespace vernier {

CaseResult run_camera_edges(const CaseSetup& setup) {
  return measured_calls(
      setup, "camera_edges", VERIFY_CAMERA, {"half ulps of 1", 8.0, 8.0},
      [](SampleRandom& random, std::uint64_t i) {
        const glm::dvec3 forward = random.direction();
        const glm::dvec3 right = glm::normalize(glm::cross(forward, random.direction()));
        const double degrees = i % 2 == 0 ? random.power_of_ten(-4.0, 2.0) : 180.0 - random.power_of_ten(-2.0, 2.0);
        const double t = std::tan(degrees * std::numbers::pi / 360.0);
        const double width = 1.0 + random.below(8192), height = 1.0 + random.below(8192);
        FunctionOperands o{};
        put(o, 0, right * t * (width / height));
        put(o, 3, glm::cross(right, forward) * t);
        put(o, 6, forward);
        put(o, 9, {width, height, width * random.unit()});
        o[12] = static_cast<float>(height * random.unit());
        return o;
      },
      [](const FunctionOperands& o, const FunctionAnswers& a) {
        const long double nx = 2.0L * o[11] / o[9] - 1.0L, ny = 1.0L - 2.0L * o[12] / o[10];
        const WideVector exact = wide_vector(o, 0) * nx + wide_vector(o, 3) * ny + wide_vector(o, 6);
        return half_ulps_apart(wide_vector(a, 0), glm::normalize(exact));
      });
}

}  // namespace vernier
