#pragma once

#include <glm/glm.hpp>

#include "reference/traced_scene.h"

namespace vernier::reference {

/// A hit seen from its ray: where it is and how the surface stands there.
struct ShadingFrame {
  glm::dvec3 position;          ///< metres, from the corners: on the plane to within rounding of its coordinates
  glm::dvec3 geometric_normal;  ///< unit, towards the viewer
  glm::dvec3 shading_normal;    ///< unit, turned with geometric_normal
  bool front = true;            ///< the front is seen
  /// Metres, from `position` to the surface that the vertex normals round the triangle off to, as far as it lies above.
  glm::dvec3 rise = glm::dvec3(0.0);
};

/// The frame of `hit` seen along `direction`: "Image formation" section 3, Normals.
ShadingFrame shading_frame(const TracedScene& scene, const Hit& hit, const glm::dvec3& direction);

}  // namespace vernier::reference
