#include "preview/interactive_scale.h"

#include <algorithm>
#include <cmath>

namespace vernier {

glm::ivec2 InteractiveScale::size(glm::ivec2 full) const {
  constexpr double kCoarsest = 16.0;
  const double pixels = static_cast<double>(full.x) * full.y;
  const double sides = std::sqrt(pixels * ms_per_pixel_ / wanted_ms_);
  const int divisor = static_cast<int>(std::clamp(std::ceil(sides), 1.0, kCoarsest));
  return glm::max((full + divisor / 2) / divisor, glm::ivec2(1));
}

void InteractiveScale::took(double pixels, double ms) {
  if (pixels <= 0.0 || ms <= 0.0) return;
  // Slower at once, faster by and by: a picture that is late is worse than one that is coarse.
  const double measured = ms / pixels;
  ms_per_pixel_ = measured > ms_per_pixel_ ? measured : 0.7 * ms_per_pixel_ + 0.3 * measured;
}

}  // namespace vernier
