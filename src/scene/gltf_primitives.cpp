#include "scene/gltf_primitives.h"

#include <cmath>
#include <limits>

#include "scene/gltf_accessors.h"

namespace vernier {
namespace {

int find_attribute(const tinygltf::Primitive& primitive, const std::string& name) {
  const auto found = primitive.attributes.find(name);
  return found == primitive.attributes.end() ? -1 : found->second;
}

bool is_ignored_set(const std::string& name) {
  if (name == "COLOR_0") return false;
  if (name.starts_with("COLOR_")) return true;
  if (!name.starts_with("TEXCOORD_")) return false;
  return name.size() != 10 || name[9] < '0' || name[9] >= static_cast<char>('0' + kUvSetCount);
}

/// Direction of `vector` in double; zero where it has none.
glm::vec3 unit_or_zero(const glm::vec3& vector) {
  const glm::dvec3 wide(vector);
  const double length = glm::length(wide);
  return length > 0.0 && std::isfinite(length) ? glm::vec3(wide / length) : glm::vec3(0.0f);
}

std::vector<std::uint32_t> corner_indices(const GltfDocument& document, const tinygltf::Primitive& primitive,
                                          std::size_t vertex_count, const std::string& place) {
  std::vector<std::uint32_t> indices;
  if (primitive.indices >= 0) {
    indices = read_gltf_indices(document, primitive.indices, place);
    for (const std::uint32_t index : indices) {
      if (index >= vertex_count) {
        refuse_gltf(document, place,
                    "index " + std::to_string(index) + " is beyond " + std::to_string(vertex_count) + " vertices");
      }
    }
    return indices;
  }
  indices.resize(vertex_count);
  for (std::size_t i = 0; i < vertex_count; ++i) indices[i] = static_cast<std::uint32_t>(i);
  return indices;
}

}  // namespace

Mesh read_gltf_vertices(GltfDocument& document, const tinygltf::Primitive& primitive, const std::string& place) {
  Mesh vertices;
  vertices.positions = read_gltf_vectors<3>(document, find_attribute(primitive, "POSITION"), place + ", POSITION");
  const std::size_t count = vertices.positions.size();
  if (const int normal = find_attribute(primitive, "NORMAL"); normal >= 0) {
    vertices.normals = read_gltf_vectors<3>(document, normal, place + ", NORMAL");
    check_element_count(document, place + ", NORMAL", vertices.normals.size(), count);
  }
  // glTF 2.0, 3.7.2.1: without normals they are ignored.
  if (const int tangent = find_attribute(primitive, "TANGENT"); tangent >= 0 && !vertices.normals.empty()) {
    vertices.tangents = read_gltf_vectors<4>(document, tangent, place + ", TANGENT");
    check_element_count(document, place + ", TANGENT", vertices.tangents.size(), count);
  }
  if (const int color = find_attribute(primitive, "COLOR_0"); color >= 0) {
    vertices.colors = read_gltf_colors(document, color, place + ", COLOR_0");
    check_element_count(document, place + ", COLOR_0", vertices.colors.size(), count);
  }
  for (std::size_t set = 0; set < kUvSetCount; ++set) {
    const std::string name = "TEXCOORD_" + std::to_string(set);
    const int uv = find_attribute(primitive, name);
    if (uv < 0) continue;
    vertices.uvs[set] = read_gltf_vectors<2>(document, uv, place + ", " + name);
    check_element_count(document, place + ", " + name, vertices.uvs[set].size(), count);
  }
  for (const auto& [name, accessor] : primitive.attributes) {
    if (is_ignored_set(name)) unsupported_gltf(document, place, "attribute " + name + " is ignored");
  }
  return vertices;
}

std::vector<glm::uvec3> read_gltf_triangles(GltfDocument& document, const tinygltf::Primitive& primitive,
                                            std::size_t vertex_count, const std::string& place) {
  const std::vector<std::uint32_t> corners = corner_indices(document, primitive, vertex_count, place);
  std::vector<glm::uvec3> triangles;
  if (primitive.mode == TINYGLTF_MODE_TRIANGLES) {
    if (corners.size() % 3 != 0) {
      warn_gltf(document, place, std::to_string(corners.size()) + " corners are no whole number of triangles");
    }
    triangles.reserve(corners.size() / 3);
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
      triangles.emplace_back(corners[i], corners[i + 1], corners[i + 2]);
    }
    return triangles;
  }
  for (std::size_t i = 0; i + 2 < corners.size(); ++i) {
    if (primitive.mode == TINYGLTF_MODE_TRIANGLE_STRIP) {
      triangles.emplace_back(corners[i], corners[i + 1 + i % 2], corners[i + 2 - i % 2]);
    } else {
      triangles.emplace_back(corners[i + 1], corners[i + 2], corners[0]);
    }
  }
  return triangles;
}

void normalise_gltf_directions(Mesh& vertices) {
  for (glm::vec3& normal : vertices.normals) normal = unit_or_zero(normal);
  for (glm::vec4& tangent : vertices.tangents) {
    const glm::vec3 direction = unit_or_zero(glm::vec3(tangent));
    const bool is_none = direction == glm::vec3(0.0f);
    tangent = is_none ? glm::vec4(0.0f) : glm::vec4(direction, tangent.w < 0.0f ? -1.0f : 1.0f);
  }
}

}  // namespace vernier
