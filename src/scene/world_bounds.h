#pragma once

#include <glm/glm.hpp>
#include <limits>

namespace vernier {

/// An axis-parallel box in metres, world space; empty by default.
struct WorldBounds {
  glm::dvec3 lo = glm::dvec3(std::numeric_limits<double>::infinity());
  glm::dvec3 hi = glm::dvec3(-std::numeric_limits<double>::infinity());
};

/// Makes `bounds` hold `point`.
inline void grow(WorldBounds& bounds, const glm::dvec3& point) {
  bounds.lo = glm::min(bounds.lo, point);
  bounds.hi = glm::max(bounds.hi, point);
}

}  // namespace vernier
