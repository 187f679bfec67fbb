#include "scene/gltf_cameras.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace vernier {
namespace {

/// Orthonormal axes with the position of `world`; false where -Z or +Y has no direction left.
bool make_rigid(const glm::dmat4& world, glm::dmat4& rigid) {
  const glm::dvec3 z = glm::normalize(glm::dvec3(world[2]));
  const glm::dvec3 x = glm::normalize(glm::cross(glm::dvec3(world[1]), z));
  const glm::dvec3 y = glm::cross(z, x);
  rigid = glm::dmat4(glm::dvec4(x, 0.0), glm::dvec4(y, 0.0), glm::dvec4(z, 0.0), world[3]);
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      if (!std::isfinite(rigid[column][row])) return false;
    }
  }
  return true;
}

void read_projection(const GltfDocument& document, int index, Camera& camera) {
  const tinygltf::Camera& source = document.model.cameras[static_cast<std::size_t>(index)];
  const std::string place = "camera " + std::to_string(index);
  if (source.type == "perspective") {
    camera.vertical_fov = source.perspective.yfov;
    if (!(camera.vertical_fov > 0.0 && camera.vertical_fov < std::numbers::pi)) {
      refuse_gltf(document, place, "yfov " + std::to_string(camera.vertical_fov) + " is not between 0 and pi");
    }
  } else if (source.type == "orthographic") {
    camera.orthographic = true;
    camera.half_height = std::abs(source.orthographic.ymag);
    if (!(camera.half_height > 0.0)) refuse_gltf(document, place, "ymag must not be 0");
  } else {
    refuse_gltf(document, place, "type \"" + source.type + "\" is not known");
  }
}

}  // namespace

std::vector<Camera> gltf_cameras(GltfDocument& document, std::span<const int> nodes,
                                 std::span<const glm::dmat4> world_from_node) {
  std::vector<std::pair<int, Camera>> found;
  for (const int node_index : nodes) {
    const tinygltf::Node& node = document.model.nodes[static_cast<std::size_t>(node_index)];
    if (node.camera < 0) continue;
    Camera camera;
    camera.name = document.model.cameras[static_cast<std::size_t>(node.camera)].name;
    if (camera.name.empty()) camera.name = node.name;
    read_projection(document, node.camera, camera);
    if (!make_rigid(world_from_node[static_cast<std::size_t>(node_index)], camera.world_from_camera)) {
      warn_gltf(document, "node " + std::to_string(node_index), "its camera has no direction and is left out");
      continue;
    }
    found.emplace_back(node.camera, std::move(camera));
  }
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Camera> cameras;
  for (auto& [number, camera] : found) cameras.push_back(std::move(camera));
  return cameras;
}

}  // namespace vernier
