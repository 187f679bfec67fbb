#include "scene/gltf_nodes.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

#include "scene/gltf_accessors.h"
#include "scene/gltf_references.h"
#include "scene/gltf_values.h"

namespace vernier {
namespace {

glm::dmat4 transform_of(const glm::dvec3& translation, const glm::dvec4& rotation_xyzw, const glm::dvec3& scale) {
  const double length = glm::length(rotation_xyzw);
  const glm::dvec4 r = length > 0 && std::isfinite(length) ? rotation_xyzw / length : glm::dvec4(0, 0, 0, 1);
  const glm::dmat4 rotation = glm::mat4_cast(glm::dquat(r.w, r.x, r.y, r.z));
  return glm::translate(glm::dmat4(1.0), translation) * rotation * glm::scale(glm::dmat4(1.0), scale);
}

glm::dmat4 affine_matrix(const GltfDocument& document, const std::vector<double>& numbers, std::size_t node) {
  constexpr double kTolerance = 1e-6;  // what exporters leave behind when they multiply matrices in float
  glm::dmat4 matrix(1.0);
  for (int i = 0; i < 16; ++i) matrix[i / 4][i % 4] = numbers[static_cast<std::size_t>(i)];
  if (matrix[3][3] > 0.0) matrix /= matrix[3][3];  // the same points
  for (int column = 0; column < 4; ++column) {
    const double wanted = column == 3 ? 1.0 : 0.0;
    if (!(std::abs(matrix[column][3] - wanted) <= kTolerance)) {
      refuse_gltf(document, "node " + std::to_string(node), "its matrix is not affine");
    }
    matrix[column][3] = wanted;
  }
  return matrix;
}

glm::dmat4 parent_from_node(const GltfDocument& document, std::size_t index) {
  const tinygltf::Node& node = document.model.nodes[index];
  if (!node.matrix.empty()) return affine_matrix(document, node.matrix, index);
  glm::dvec3 translation(0.0);
  glm::dvec4 rotation(0, 0, 0, 1);
  glm::dvec3 scale(1.0);
  if (!node.translation.empty()) translation = {node.translation[0], node.translation[1], node.translation[2]};
  if (!node.rotation.empty()) rotation = {node.rotation[0], node.rotation[1], node.rotation[2], node.rotation[3]};
  if (!node.scale.empty()) scale = {node.scale[0], node.scale[1], node.scale[2]};
  return transform_of(translation, rotation, scale);
}

std::vector<int> roots_of(const tinygltf::Model& model) {
  std::vector<bool> is_child(model.nodes.size(), false);
  for (const tinygltf::Node& node : model.nodes) {
    for (const int child : node.children) is_child[static_cast<std::size_t>(child)] = true;
  }
  std::vector<int> roots;
  for (std::size_t i = 0; i < is_child.size(); ++i) {
    if (!is_child[i]) roots.push_back(static_cast<int>(i));
  }
  return roots;
}

/// By KHR_node_visibility.
bool is_visible(const tinygltf::Node& node) {
  const tinygltf::Value* extension = find_gltf_extension(node.extensions, "KHR_node_visibility");
  if (extension == nullptr || !extension->Get("visible").IsBool()) return true;
  return extension->Get("visible").Get<bool>();
}

/// What an instance takes while the file is read: its transform, twice, and what it is made of.
constexpr std::uint64_t kInstanceBytes = 2 * sizeof(glm::dmat4) + 40;

int instancing_accessor(const GltfDocument& document, const tinygltf::Value& attributes, const char* name,
                        const std::string& place, std::size_t& count) {
  const int accessor = gltf_index(attributes, name, -1);
  if (!attributes.Has(name)) return -1;
  check_gltf_index(document, place, "accessor", accessor, document.model.accessors.size());
  const std::size_t elements = document.model.accessors[static_cast<std::size_t>(accessor)].count;
  if (count != 0 && elements != count) refuse_gltf(document, place, "its attributes have different counts");
  count = elements;
  if (document.model.accessors[static_cast<std::size_t>(accessor)].bufferView < 0) {
    count_gltf_zeros(document, place, count * kInstanceBytes);
  }
  return accessor;
}

}  // namespace

std::vector<glm::dmat4> gltf_world_matrices(const GltfDocument& document) {
  const std::vector<tinygltf::Node>& nodes = document.model.nodes;
  std::vector<glm::dmat4> world_from_node(nodes.size());
  std::vector<int> order = roots_of(document.model);
  for (const int root : order) {
    world_from_node[static_cast<std::size_t>(root)] = parent_from_node(document, static_cast<std::size_t>(root));
  }
  for (std::size_t next = 0; next < order.size(); ++next) {
    const auto parent = static_cast<std::size_t>(order[next]);
    for (const int child : nodes[parent].children) {
      const auto node = static_cast<std::size_t>(child);
      world_from_node[node] = world_from_node[parent] * parent_from_node(document, node);
      order.push_back(child);
    }
  }
  return world_from_node;
}

GltfSceneNodes gltf_scene_nodes(const GltfDocument& document) {
  const tinygltf::Model& model = document.model;
  const std::size_t scene = model.defaultScene < 0 ? 0 : static_cast<std::size_t>(model.defaultScene);
  const std::vector<int> roots = model.scenes.empty() ? roots_of(model) : model.scenes[scene].nodes;
  std::vector<bool> is_met(model.nodes.size(), false);
  std::vector<bool> is_hidden(model.nodes.size(), false);  // by itself or by one above
  std::vector<int> pending(roots.rbegin(), roots.rend());
  GltfSceneNodes met;
  while (!pending.empty()) {
    const int index = pending.back();
    pending.pop_back();
    const auto node = static_cast<std::size_t>(index);
    if (is_met[node]) refuse_gltf(document, "node " + std::to_string(index), "the scene reaches it twice");
    is_met[node] = true;
    if (!is_visible(model.nodes[node])) is_hidden[node] = true;
    met.all.push_back(index);
    if (!is_hidden[node]) met.visible.push_back(index);
    const std::vector<int>& children = model.nodes[node].children;
    for (const int child : children) is_hidden[static_cast<std::size_t>(child)] = is_hidden[node];
    pending.insert(pending.end(), children.rbegin(), children.rend());
  }
  return met;
}

std::vector<glm::dmat4> gltf_node_instances(const GltfDocument& document, int node) {
  const tinygltf::Value* extension =
      find_gltf_extension(document.model.nodes[static_cast<std::size_t>(node)].extensions, "EXT_mesh_gpu_instancing");
  if (extension == nullptr || !extension->Has("attributes")) return {glm::dmat4(1.0)};
  const tinygltf::Value& attributes = extension->Get("attributes");
  const std::string place = "node " + std::to_string(node) + ", EXT_mesh_gpu_instancing";
  std::size_t count = 0;
  // Those of others count too (the extension's README: all are optional). Reading checks their counts against the file.
  for (const std::string& name : attributes.Keys())
    read_gltf_elements(document, instancing_accessor(document, attributes, name.c_str(), place, count), place);
  const int translation = instancing_accessor(document, attributes, "TRANSLATION", place, count);
  const int rotation = instancing_accessor(document, attributes, "ROTATION", place, count);
  const int scale = instancing_accessor(document, attributes, "SCALE", place, count);
  std::vector<glm::vec3> translations, scales;
  std::vector<glm::vec4> rotations;
  if (translation >= 0) translations = read_gltf_vectors<3>(document, translation, place);
  if (rotation >= 0) rotations = read_gltf_vectors<4>(document, rotation, place);
  if (scale >= 0) scales = read_gltf_vectors<3>(document, scale, place);
  translations.resize(count, glm::vec3(0.0f));
  rotations.resize(count, glm::vec4(0, 0, 0, 1));
  scales.resize(count, glm::vec3(1.0f));
  std::vector<glm::dmat4> instances;
  for (std::size_t i = 0; i < count; ++i) instances.push_back(transform_of(translations[i], rotations[i], scales[i]));
  return instances;
}

}  // namespace vernier
