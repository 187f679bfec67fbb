#pragma once

#include "scene/scene.h"

namespace vernier {

/// Leaves out the normals of meshes whose every triangle has its own normal at its corners, on either side, to within
/// what rounding makes of an interpolated normal: they say nothing that the positions do not. Such a mesh is marked
/// flat_normals. `scene` has passed validate_scene. O(triangles) of those meshes, less of the others.
void drop_flat_normals(Scene& scene);

}  // namespace vernier
