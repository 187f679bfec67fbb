#pragma once

#include <glm/glm.hpp>

#include "scene/camera.h"

namespace vernier::reference {

/// A half line in world space, metres; `direction` is unit, so t counts metres.
struct Ray {
  glm::dvec3 origin;
  glm::dvec3 direction;
};

/// The ray through `position` (in pixels of a width x height image, row 0 on top; the centre of pixel (x, y) is
/// (x + 1/2, y + 1/2)). "Image formation" section 2. width and height are positive.
Ray camera_ray(const Camera& camera, int width, int height, glm::dvec2 position);

}  // namespace vernier::reference
