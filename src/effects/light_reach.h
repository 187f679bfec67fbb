#pragma once

#include <glm/glm.hpp>
#include <limits>

#include "scene/scene.h"

namespace vernier {

/// An axis-parallel box in metres, world space; empty by default.
struct WorldBox {
  glm::dvec3 low = glm::dvec3(std::numeric_limits<double>::infinity());
  glm::dvec3 high = glm::dvec3(-std::numeric_limits<double>::infinity());
};

/// A box around all triangles of the scene's instances: around the placed boxes of their meshes, so it may be too
/// large. Vertices that no triangle uses count. O(vertices + instances).
WorldBox world_box(const Scene& scene);

/// Whether the range of a point or spot light reaches into `box`. True wherever rounding leaves a doubt, and for a
/// light or box that is not finite.
bool light_reaches(const Light& light, const WorldBox& box);

}  // namespace vernier
