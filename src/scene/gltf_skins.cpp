#include "scene/gltf_skins.h"

#include <algorithm>

#include "scene/gltf_accessors.h"

namespace vernier {
namespace {

/// The matrix that carries normals where `matrix` carries points, up to a positive factor; also for a singular one.
glm::dmat3 normal_matrix(const glm::dmat3& matrix) {
  const glm::dmat3 cofactors(glm::cross(matrix[1], matrix[2]), glm::cross(matrix[2], matrix[0]),
                             glm::cross(matrix[0], matrix[1]));
  return glm::determinant(matrix) < 0.0 ? -cofactors : cofactors;
}

struct Influence {
  std::vector<glm::uvec4> joints;
  std::vector<glm::vec4> weights;
};

std::vector<Influence> read_influences(const GltfDocument& document, const tinygltf::Primitive& primitive,
                                       const std::string& place, std::size_t vertex_count) {
  std::vector<Influence> influences;
  for (int set = 0;; ++set) {
    const auto joints = primitive.attributes.find("JOINTS_" + std::to_string(set));
    const auto weights = primitive.attributes.find("WEIGHTS_" + std::to_string(set));
    if (joints == primitive.attributes.end() || weights == primitive.attributes.end()) return influences;
    const std::string joints_place = place + ", JOINTS_" + std::to_string(set);
    const std::string weights_place = place + ", WEIGHTS_" + std::to_string(set);
    influences.push_back({read_gltf_joints(document, joints->second, joints_place),
                          read_gltf_vectors<4>(document, weights->second, weights_place)});
    check_element_count(document, joints_place, influences.back().joints.size(), vertex_count);
    check_element_count(document, weights_place, influences.back().weights.size(), vertex_count);
  }
}

/// Sum of weight times matrix over all joints of vertex `v`, and the weights' sum.
double blend_joints(const GltfDocument& document, const std::vector<Influence>& influences,
                    std::span<const glm::dmat4> joints, std::size_t v, const std::string& place, glm::dmat4& blended) {
  double sum = 0.0;
  blended = glm::dmat4(0.0);
  for (const Influence& influence : influences) {
    for (int k = 0; k < 4; ++k) {
      const double weight = influence.weights[v][k];
      const std::uint32_t joint = influence.joints[v][k];
      if (!(weight > 0.0)) continue;
      if (joint >= joints.size()) {
        refuse_gltf(document, place,
                    "joint " + std::to_string(joint) + " is beyond " + std::to_string(joints.size()) + " joints");
      }
      blended += weight * joints[joint];
      sum += weight;
    }
  }
  return sum;
}

}  // namespace

void apply_gltf_morph_targets(GltfDocument& document, const tinygltf::Primitive& primitive,
                              std::span<const double> weights, const std::string& place, Mesh& vertices) {
  const std::size_t count = vertices.positions.size();
  for (std::size_t t = 0; t < std::min(primitive.targets.size(), weights.size()); ++t) {
    if (weights[t] == 0.0) continue;
    const auto weight = static_cast<float>(weights[t]);
    for (const auto& [name, accessor] : primitive.targets[t]) {
      const std::string target_place = place + ", target " + std::to_string(t) + " " + name;
      if (name != "POSITION" && name != "NORMAL" && name != "TANGENT") {
        unsupported_gltf(document, target_place, "ignored");
        continue;
      }
      const std::vector<glm::vec3> offsets = read_gltf_vectors<3>(document, accessor, target_place);
      check_element_count(document, target_place, offsets.size(), count);
      for (std::size_t v = 0; v < count; ++v) {
        if (name == "POSITION") vertices.positions[v] += weight * offsets[v];
        if (name == "NORMAL" && !vertices.normals.empty()) vertices.normals[v] += weight * offsets[v];
        if (name == "TANGENT" && !vertices.tangents.empty()) {
          vertices.tangents[v] += glm::vec4(weight * offsets[v], 0.0f);
        }
      }
    }
  }
}

std::vector<glm::dmat4> gltf_joint_matrices(const GltfDocument& document, int index,
                                            std::span<const glm::dmat4> world_from_node) {
  const tinygltf::Skin& skin = document.model.skins[static_cast<std::size_t>(index)];
  const std::string place = "skin " + std::to_string(index);
  std::vector<glm::mat4> inverse_binds(skin.joints.size(), glm::mat4(1.0f));
  if (skin.inverseBindMatrices >= 0) inverse_binds = read_gltf_matrices(document, skin.inverseBindMatrices, place);
  if (inverse_binds.size() < skin.joints.size()) {
    refuse_gltf(document, place,
                std::to_string(inverse_binds.size()) + " inverse bind matrices are fewer than " +
                    std::to_string(skin.joints.size()) + " joints");
  }
  std::vector<glm::dmat4> matrices;
  for (std::size_t j = 0; j < skin.joints.size(); ++j) {
    matrices.push_back(world_from_node[static_cast<std::size_t>(skin.joints[j])] * glm::dmat4(inverse_binds[j]));
  }
  return matrices;
}

void apply_gltf_skin(GltfDocument& document, const tinygltf::Primitive& primitive, std::span<const glm::dmat4> joints,
                     const std::string& place, Mesh& vertices) {
  const std::vector<Influence> influences = read_influences(document, primitive, place, vertices.positions.size());
  if (influences.empty())
    warn_gltf(document, place, "it has a skin but not both JOINTS_0 and WEIGHTS_0, and stays where it is");
  for (std::size_t v = 0; v < vertices.positions.size(); ++v) {
    glm::dmat4 blended;
    const double sum = blend_joints(document, influences, joints, v, place, blended);
    if (!(sum > 0.0)) continue;
    const glm::dmat4 world_from_vertex = blended / sum;
    vertices.positions[v] = glm::vec3(world_from_vertex * glm::dvec4(vertices.positions[v], 1.0));
    const glm::dmat3 linear(world_from_vertex);
    if (!vertices.normals.empty())
      vertices.normals[v] = glm::vec3(normal_matrix(linear) * glm::dvec3(vertices.normals[v]));
    if (!vertices.tangents.empty()) {
      const glm::dvec3 tangent = linear * glm::dvec3(vertices.tangents[v]);
      vertices.tangents[v] = glm::vec4(glm::vec3(tangent), vertices.tangents[v].w);
    }
  }
}

}  // namespace vernier
