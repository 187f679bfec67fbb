#pragma once

#include "scene/scene.h"
#include "scene/world_bounds.h"

namespace vernier {

/// A box around all triangles of the scene's instances: around the placed boxes of their meshes, so it may be too
/// large. Vertices that no triangle uses count. O(vertices + instances).
WorldBounds world_box(const Scene& scene);

/// Whether the range of a point or spot light reaches into `box`. True wherever rounding leaves a doubt, and for a
/// light or box that is not finite.
bool light_reaches(const Light& light, const WorldBounds& box);

}  // namespace vernier
