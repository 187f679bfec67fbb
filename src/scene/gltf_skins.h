#pragma once

#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

#include "scene/gltf_document.h"

namespace vernier {

/// Adds each morph target of `primitive` times its weight to positions, normals and tangents of `vertices` (all without
/// re-normalising). Missing weights are 0, surplus ones are ignored. Targets of other attributes are unsupported.
/// Throws Error(refused) for a target with another count than the vertices.
void apply_gltf_morph_targets(GltfDocument& document, const tinygltf::Primitive& primitive,
                              std::span<const double> weights, const std::string& place, Mesh& vertices);

/// world_from_bind of each joint of `skin`: the joint's world matrix times its inverse bind matrix (identity without
/// one).
std::vector<glm::dmat4> gltf_joint_matrices(const GltfDocument& document, int skin,
                                            std::span<const glm::dmat4> world_from_node);

/// Moves `vertices` to world space by the weighted mean of their joints' matrices (linear blend skinning; glTF 2.0,
/// section 3.7.3.3), all JOINTS_n / WEIGHTS_n sets taken together; weights are divided by their sum. Normals go by the
/// cofactor matrix. Vertices without weight, and primitives without joints (with a warning), stay where they are.
/// Throws Error(refused) for a weighted joint that the skin does not have.
void apply_gltf_skin(GltfDocument& document, const tinygltf::Primitive& primitive, std::span<const glm::dmat4> joints,
                     const std::string& place, Mesh& vertices);

}  // namespace vernier
