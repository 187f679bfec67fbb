#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <map>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "scene/gltf_document.h"

namespace vernier {

/// What decides how a glTF mesh comes out: its number, its skin (-1: none) and the weights of its morph targets.
using GltfPose = std::tuple<int, int, std::vector<double>>;

/// Meshes made so far and what there is to say about them at the end.
struct GltfMeshes {
  std::map<GltfPose, std::uint32_t> made;  ///< number in Scene::meshes
  std::uint64_t vertex_count = 0;
  std::uint64_t triangle_count = 0;
  std::uint64_t skipped_primitives = 0;  ///< points and lines
  std::string first_skipped;
  bool uses_default_material = false;  ///< material number model.materials.size()
};

/// Number in scene.meshes of the mesh that `node` shows: all primitives of the glTF mesh appended, in the pose of the
/// node's skin (then in world space) and weights; made on first use and shared by nodes with the same pose.
/// Throws Error(refused) for anything broken in it and beyond 2^28 vertices or triangles in all.
std::uint32_t gltf_mesh_of_node(GltfDocument& document, int node, std::span<const glm::dmat4> world_from_node,
                                GltfMeshes& meshes, Scene& scene);

}  // namespace vernier
