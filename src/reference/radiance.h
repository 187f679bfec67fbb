#pragma once

#include <cstdint>
#include <glm/glm.hpp>

#include "reference/traced_scene.h"

namespace vernier::reference {

/// How far paths are followed.
struct PathLimits {
  std::uint32_t max_bounces = 8;  ///< reflections and refractions one after the other
  double cutoff = 0.0009765625;   ///< a ray whose largest weight is below is not traced
};

/// What a camera ray brings back.
struct Arrival {
  glm::dvec3 radiance;
  bool hit = false;  ///< it met anything
};

/// The light that comes in along `ray`, which starts in the open: "Image formation" section 5. The time can grow as
/// 2^max_bounces where paths fork, the memory as max_bounces. A NaN of the scene is passed on.
Arrival radiance(const TracedScene& scene, const PathLimits& limits, const Ray& ray);

}  // namespace vernier::reference
