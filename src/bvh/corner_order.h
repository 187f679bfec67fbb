#pragma once

#include <cstdint>
#include <glm/glm.hpp>

namespace vernier {

/// The corner of v0 v1 v2 opposite the longest edge: 0, 1 or 2, the lowest of equals. Triangles are traced from that
/// corner on (v0 in the records): the two edges at it are the shortest, so that their cross product keeps most digits
/// of a needle's normal.
inline int corner_opposite_longest_edge(const glm::vec3& v0, const glm::vec3& v1, const glm::vec3& v2) {
  const auto length_squared = [](const glm::vec3& a, const glm::vec3& b) {
    const glm::dvec3 edge = glm::dvec3(b) - glm::dvec3(a);
    return glm::dot(edge, edge);
  };
  const double opposite0 = length_squared(v1, v2), opposite1 = length_squared(v2, v0),
               opposite2 = length_squared(v0, v1);
  if (opposite0 >= opposite1 && opposite0 >= opposite2) return 0;
  return opposite1 >= opposite2 ? 1 : 2;
}

}  // namespace vernier
