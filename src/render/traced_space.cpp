#include "render/traced_space.h"

#include <algorithm>
#include <cmath>

namespace vernier {

TracedSpace choose_traced_space(const WorldBounds& bounds) {
  TracedSpace space;
  if (!(bounds.lo.x <= bounds.hi.x)) return space;
  double largest = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    const double lo = bounds.lo[axis];
    const double hi = bounds.hi[axis];
    const bool contains_zero = lo <= 0.0 && hi >= 0.0;
    space.center[axis] = contains_zero ? 0.0 : static_cast<double>(static_cast<float>(lo + (hi - lo) / 2.0));
    largest = std::max({largest, std::abs(lo - space.center[axis]), std::abs(hi - space.center[axis])});
  }
  if (largest > 0.0) space.metres_per_unit = std::exp2(std::ceil(std::log2(largest)));
  return space;
}

glm::dvec3 traced_from_world(const TracedSpace& space, const glm::dvec3& world) {
  return (world - space.center) / space.metres_per_unit;
}

}  // namespace vernier
