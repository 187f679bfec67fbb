#pragma once

#include <glm/glm.hpp>

#include "scene/frame_scene.h"
#include "scene/scene.h"

namespace vernier {

/// What a small parallel view of a scene shows: shares of its pixels, in [0, 1].
struct SideView {
  double covered;  ///< by any triangle
  double backs;    ///< of the covered ones, where the nearest triangle turns its back; 0 where none is covered
};

/// The view from `side` (unit, from the scene towards the eye). Winding alone tells a back, `double_sided` does not:
/// the outer side of a room's wall is its back either way. Of very many triangles an even selection is looked at.
SideView look_from(const Scene& scene, const WorldBounds& bounds, const glm::dvec3& side);

/// Unit direction from the scene, which has passed validate_scene, towards an eye that sees it well: `usual`, unless
/// more than a quarter of what it shows are backs (a room seen from outside). Then the first of straight in front,
/// right, left and behind that shows hardly any and at least half as much of the scene; `usual` where none does.
glm::dvec3 choose_view_side(const Scene& scene, const WorldBounds& bounds, const glm::dvec3& usual);

}  // namespace vernier
