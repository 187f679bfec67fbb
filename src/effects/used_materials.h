#pragma once

#include <vector>

#include "scene/scene.h"

namespace vernier {

/// How the triangles of a scene use one material.
struct MaterialUsage {
  bool used = false;            ///< by a triangle of an instance that can be hit
  bool vertex_colors = false;   ///< one of these triangles has vertex colours
  bool vertex_normals = false;  ///< one of these triangles has a normal at all three corners
};

/// Usage of every material of `scene`, by index. Triangles with two equal corners have no area and do not count;
/// those that are merely thin do, because rounding may give them area once they are transformed.
/// Meshes without an instance are not seen. `scene` has passed validate_scene; O(triangles).
std::vector<MaterialUsage> used_materials(const Scene& scene);

}  // namespace vernier
