#pragma once

#include <glm/glm.hpp>

namespace vernier {

/// True when the corners lie exactly on one line (or in one point), judged on the float coordinates without rounding:
/// the real cross product (v1 - v0) x (v2 - v0) is zero. All coordinates are finite. A triangle that is merely thin
/// has area, however small.
bool has_zero_area(const glm::vec3& v0, const glm::vec3& v1, const glm::vec3& v2);

}  // namespace vernier
