#pragma once

#include <glm/glm.hpp>

#include "scene/scene.h"
#include "scene/world_bounds.h"

namespace vernier {

/// The bounds of `scene`, which has passed validate_scene. Triangles with two equal corners do not count, nor
/// do dropped ones; those whose corners lie in a line do, since rounding may give them area once they are transformed.
/// Where nothing is left lo is +infinity and hi -infinity. Where instances have more than 2^22 vertices together, those
/// of a mesh that is placed twice and more are bounded by its box. O(triangles of the meshes + instances).
WorldBounds world_bounds(const Scene& scene);

/// The same without triangles that are lines: what there is to see.
WorldBounds seen_bounds(const Scene& scene);

/// A camera at three quarters (from +X +Y +Z) with `vertical_fov` that sees all of `bounds` in an image of
/// `aspect` = width / height: the nearest eye whose picture the box fills, but for a margin of 5 %, in width or height;
/// it lies in the picture's middle in both. A box thinner than 1/1000 of its largest extent on one axis is seen from
/// nearer that axis's positive side. A box without extent is given 1 metre, an empty one that at the origin.
Camera frame_camera(const WorldBounds& bounds, double vertical_fov, double aspect);

/// The same for the vertices of all triangles of `scene`, which has passed validate_scene, but a room that would be
/// seen from outside is seen through the side where it is open (choose_view_side).
/// `up` is up in the picture; what lies along the line of sight counts as (0, 1, 0).
Camera frame_scene(const Scene& scene, double vertical_fov, double aspect, const glm::dvec3& up = {0.0, 1.0, 0.0});

/// The lights of add_default_lighting for a scene that brings none, seen through `camera`: always as many.
std::vector<Light> default_lights(const Camera& camera);

/// Adds what a scene without lights and environment is shown with: a directional key from above and beside `camera`,
/// a weaker fill from its other side and a soft gradient environment. A scene with lights gets the gradient alone, at a
/// third of its level: scene files cannot say what is around them, and in black surroundings metals would be black. An
/// environment that is not black, or an ambient override, stays as the caller set it.
void add_default_lighting(Scene& scene, const Camera& camera);

}  // namespace vernier
