#pragma once

#include <glm/glm.hpp>

#include "scene/camera.h"
#include "scene/frame_scene.h"

namespace vernier {

/// A camera and the point it turns around.
struct OrbitView {
  Camera camera;
  glm::dvec3 target = glm::dvec3(0.0);  ///< metres, in front of the camera on its line of sight
};

/// `camera` with the point of its line of sight that is nearest to the middle of `bounds`, but never nearer to the eye
/// than a thousandth of their extent.
OrbitView orbit_view(const Camera& camera, const WorldBounds& bounds);

/// `view` moved so that it sees all of `bounds` in a picture of `aspect` = width / height, from three quarters.
OrbitView framed(const OrbitView& view, const WorldBounds& bounds, double aspect);

/// Turned around the target: `yaw` radians about the world's +Y, to the right where positive, then `pitch` upwards. The
/// eye stays a degree away from looking along Y, where there would be no telling left from right.
OrbitView orbited(const OrbitView& view, double yaw, double pitch);

/// Moved across the line of sight by so many heights of the picture at the target's distance, right and up.
OrbitView panned(const OrbitView& view, double right, double up);

/// The distance to the target, or what an orthographic camera sees, times `factor` (above 0).
OrbitView zoomed(const OrbitView& view, double factor);

/// Camera and target moved by so many of their distances: right, up and forward.
OrbitView moved(const OrbitView& view, const glm::dvec3& steps);

}  // namespace vernier
