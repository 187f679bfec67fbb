#pragma once

#include <cstdint>
#include <vector>

#include "bvh/bvh.h"
#include "render/plan_instances.h"
#include "render/traced_space.h"
#include "scene/scene.h"

namespace vernier {

/// Where the attributes of a vertex lie, in uvec4 texels from its start; NONE: not there (render_constants.h).
struct VertexLayout {
  std::uint32_t texels = 0;
  std::uint32_t normal, uv01, uv23, color, tangent;
};

/// Which UV sets vertices get, beside those that textures are read by.
enum class UvSets { of_textures, all };

/// A texel for each attribute that any mesh of `scene` has and something reads: tangents where there are normal
/// textures alone. The first, where there is any, is the normal's, with which the material goes.
VertexLayout choose_vertex_layout(const Scene& scene, UvSets uvs);

/// The instances that are copied as one list of triangles in the traced space, in the order of the global triangle
/// numbers, and the arrays to which bake_shared_mesh adds the other meshes.
struct BakedScene {
  std::vector<BvhTriangle> corners;            ///< [triangle], id = index
  std::vector<std::uint32_t> triangles;        ///< [triangle][4]: vertices 0, 1, 2, material
  std::vector<std::uint32_t> vertices;         ///< [vertex][layout.texels][4] float bits
  std::vector<std::uint32_t> numbers;          ///< [triangle] global number; empty where it is the index
  std::vector<std::uint32_t> first_triangles;  ///< [instance] global number of its first triangle
  VertexLayout layout;
};

/// Bakes `scene`, which has passed validate_scene: positions in double, rounded once; normals by the inverse transpose;
/// corners 1 and 2 change places where the transform mirrors. Attributes that no mesh has take no memory.
/// Instances that `plan` (of the same scene) shares are left out. Throws Error(refused) beyond 2^32 - 1 vertices or
/// triangles.
BakedScene bake_instances(const Scene& scene, const TracedSpace& space, const InstancePlan& plan, UvSets uvs);

/// Adds mesh `mesh` in its own `space` to `baked` as if it were placed by the identity; its corners, ids counted from
/// 0.
std::vector<BvhTriangle> bake_shared_mesh(const Mesh& mesh, const TracedSpace& space, BakedScene& baked);

}  // namespace vernier
