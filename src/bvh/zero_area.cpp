#include "bvh/zero_area.h"

#include <array>
#include <cmath>

namespace vernier {
namespace {

// Is the sum of `terms` exactly zero? Adds them one by one into an expansion, a sum of doubles that do not overlap
// (Shewchuk 1997, Adaptive Precision Floating-Point Arithmetic, section 2.4): the expansion is zero only when each part
// is.
bool sums_to_zero(const std::array<double, 6>& terms) {
  std::array<double, 6> parts{};
  std::size_t part_count = 0;
  for (double carry : terms) {
    for (std::size_t i = 0; i < part_count; ++i) {
      const double sum = carry + parts[i];
      const double virtual_part = sum - carry;
      parts[i] = (carry - (sum - virtual_part)) + (parts[i] - virtual_part);
      carry = sum;
    }
    parts[part_count++] = carry;
  }
  for (std::size_t i = 0; i < part_count; ++i) {
    if (parts[i] != 0.0) {
      return false;
    }
  }
  return true;
}

// Is one component of the cross product exactly zero? The corners are a, b, c in the plane of the component.
bool component_is_zero(double ax, double ay, double bx, double by, double cx, double cy) {
  const double left = (bx - ax) * (cy - ay);
  const double right = (by - ay) * (cx - ax);
  // Each product carries three roundings of 2^-53; their difference one more. 2^-50 of the sum is above all of them.
  if (std::abs(left - right) > 0x1p-50 * (std::abs(left) + std::abs(right))) {
    return false;
  }
  // Expanded, every term is a product of two floats: 48 bits, exact in double; 2^-298 and 2^256 are in its range too.
  return sums_to_zero({bx * cy, -bx * ay, -ax * cy, -by * cx, by * ax, ay * cx});
}

}  // namespace

bool has_zero_area(const glm::vec3& v0, const glm::vec3& v1, const glm::vec3& v2) {
  return component_is_zero(v0.x, v0.y, v1.x, v1.y, v2.x, v2.y) &&
         component_is_zero(v0.y, v0.z, v1.y, v1.z, v2.y, v2.z) && component_is_zero(v0.z, v0.x, v1.z, v1.x, v2.z, v2.x);
}

}  // namespace vernier
