#pragma once

#include <glm/glm.hpp>

#include "scene/scene.h"

namespace vernier {

/// World-space box around all triangles of all instances, in double. Zero-area triangles count too.
struct WorldBounds {
  glm::dvec3 lo;
  glm::dvec3 hi;
};

/// The bounds of `scene`, which has passed validate_scene.
WorldBounds world_bounds(const Scene& scene);

/// A camera at three quarters (from +X +Y +Z) with `vertical_fov` that sees all of `bounds` in an image of
/// `aspect` = width / height, touching it. A box without extent is given 1 metre.
Camera frame_camera(const WorldBounds& bounds, double vertical_fov, double aspect);

/// Adds what a scene without lights and environment is shown with: a directional key from above and beside `camera`,
/// a weaker fill from its other side and a soft gradient environment. Does nothing where the file brings lights
/// (then the environment stays black) unless the caller set an environment.
void add_default_lighting(Scene& scene, const Camera& camera);

}  // namespace vernier
