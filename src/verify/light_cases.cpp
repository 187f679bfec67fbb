#include "verify/light_cases.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "shared/light_kinds.h"
#include "verify/function_kernel.h"
#include "verify/level_bound.h"
#include "verify/random.h"
#include "verify/tally.h"

namespace vernier {

CaseResult run_hdr_light(const CaseSetup& setup) {
  constexpr double kBound = 1e-5;  // docstring
  constexpr long double kLargest = std::numeric_limits<float>::max(), kLeast = std::numeric_limits<float>::min();
  std::vector<FunctionOperands> operands(setup.sample_count);
  for (std::uint64_t i = 0; i < setup.sample_count; ++i) {
    SampleRandom random(setup.seed, "hdr_light", i);
    const glm::dvec3 place = random.direction() * random.power_of_ten(-10.0, 10.0);
    operands[i] = {static_cast<float>(place.x),
                   static_cast<float>(place.y),
                   static_cast<float>(place.z),
                   LIGHT_POINT,
                   0,
                   0,
                   -1,
                   std::numeric_limits<float>::infinity(),
                   static_cast<float>(random.power_of_ten(-30.0, 30.0))};
  }
  const auto answers = call_shader_function(setup, VERIFY_LIGHT, operands);
  Tally tally("relative", level_bound(setup, kBound, kBound));
  for (std::size_t i = 0; i < operands.size(); ++i) {
    const FunctionOperands& o = operands[i];
    const glm::vec<3, long double> place(o[0], o[1], o[2]);
    const long double exact = o[8] / glm::dot(place, place);
    const float got = answers[i][3];
    double error = static_cast<double>(std::abs(got - exact) / exact);
    // Beyond the range: infinity, or anything up to the smallest normal number.
    if (exact > kLargest) error = got >= std::numeric_limits<float>::max() ? 0.0 : 1.0;
    if (exact < kLeast) error = got >= 0.0f && got <= 2.0f * kLeast ? 0.0 : 1.0;
    tally.book_error(error, [&] { return hex_floats({{"x", o[0]}, {"y", o[1]}, {"z", o[2]}, {"intensity", o[8]}}); });
  }
  return tally.result();
}

}  // namespace vernier
