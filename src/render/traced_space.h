#pragma once

#include <glm/glm.hpp>

#include "scene/frame_scene.h"

namespace vernier {

/// The space that is traced: world = traced x metres_per_unit + center. metres_per_unit is a power of two, so scaling
/// changes no digit, and the scene's largest coordinate comes to lie in (1/2, 1].
struct TracedSpace {
  glm::dvec3 center = glm::dvec3(0.0);
  double metres_per_unit = 1.0;
};

/// The traced space of a scene with `bounds`. On an axis along which the scene contains 0 the center stays 0: float
/// coordinates then survive exactly, with the detail that the author put near the origin; elsewhere it is the middle of
/// the bounds, rounded to float. A single point gives one metre per unit, as do empty bounds (lo > hi).
TracedSpace choose_traced_space(const WorldBounds& bounds);

/// `world` (metres) in the traced space, in double.
glm::dvec3 traced_from_world(const TracedSpace& space, const glm::dvec3& world);

}  // namespace vernier
