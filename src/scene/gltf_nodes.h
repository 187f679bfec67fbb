#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "scene/gltf_document.h"

namespace vernier {

/// world_from_node of every node of the file, by number. Translation, rotation and scale are multiplied in that order;
/// a rotation is normalised, a zero one is none. O(nodes), whatever the depth. Throws Error(refused) for a matrix whose
/// last row is not (0, 0, 0, 1) within 1e-6.
std::vector<glm::dmat4> gltf_world_matrices(const GltfDocument& document);

/// Nodes of a scene by number, parents before children, depth first.
struct GltfSceneNodes {
  std::vector<int> all;
  std::vector<int> visible;  ///< by KHR_node_visibility, which hides meshes and lights, but no camera
};

/// The nodes of the default scene, without one of scene 0, without scenes of all roots. Throws Error(refused) where a
/// node is reached twice.
GltfSceneNodes gltf_scene_nodes(const GltfDocument& document);

/// node_from_instance of EXT_mesh_gpu_instancing, in order; one identity where `node` does not carry it.
std::vector<glm::dmat4> gltf_node_instances(const GltfDocument& document, int node);

}  // namespace vernier
