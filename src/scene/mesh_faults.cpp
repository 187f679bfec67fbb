#include "scene/mesh_faults.h"

#include <algorithm>
#include <cmath>

namespace vernier {
namespace {

template <int N>
bool is_finite(const glm::vec<N, float>& v) {
  for (int i = 0; i < N; ++i) {
    if (!std::isfinite(v[i])) return false;
  }
  return true;
}

std::string place(std::size_t mesh_index, const char* what, std::size_t index) {
  return "mesh " + std::to_string(mesh_index) + ", " + what + " " + std::to_string(index);
}

template <int N>
void replace_non_finite(std::vector<glm::vec<N, float>>& values, const glm::vec<N, float>& none, const char* name,
                        std::size_t mesh_index, FaultList& faults) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (is_finite(values[i])) continue;
    values[i] = none;
    faults.add(std::string("non-finite ") + name + " are ignored", place(mesh_index, "vertex", i));
  }
}

/// A float keeps 24 bits: beyond 2^16 fewer than 8 are left for the place within a texture's period.
constexpr float kLargestUv = 0x1p16f;

void tell_coarse_uvs(const std::vector<glm::vec2>& uvs, std::size_t mesh_index, FaultList& faults) {
  for (std::size_t i = 0; i < uvs.size(); ++i) {
    if (std::max(std::abs(uvs[i].x), std::abs(uvs[i].y)) <= kLargestUv) continue;
    faults.add("texture coordinates beyond 65536 are too coarse to place a texture", place(mesh_index, "vertex", i));
  }
}

void drop_triangles(Mesh& mesh, std::size_t mesh_index, FaultList& faults) {
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    glm::uvec3& triangle = mesh.triangles[i];
    bool in_range = true;
    bool finite = true;
    for (int c = 0; c < 3; ++c) {
      if (triangle[c] >= mesh.positions.size()) {
        in_range = false;
      } else if (!is_finite(mesh.positions[triangle[c]])) {
        finite = false;
      }
    }
    if (in_range && finite) continue;
    triangle = glm::uvec3(0);
    faults.add(in_range ? "triangles with a non-finite corner are dropped"
                        : "triangles with an index out of range are dropped",
               place(mesh_index, "triangle", i));
  }
}

}  // namespace

bool has_area(const Mesh& mesh, const glm::uvec3& triangle) {
  const glm::dvec3 corner(mesh.positions[triangle.x]);
  const glm::dvec3 side(glm::dvec3(mesh.positions[triangle.y]) - corner);
  return glm::cross(side, glm::dvec3(mesh.positions[triangle.z]) - corner) != glm::dvec3(0.0);
}

void repair_mesh(Mesh& mesh, std::size_t mesh_index, FaultList& faults) {
  drop_triangles(mesh, mesh_index, faults);
  if (mesh.positions.empty() && !mesh.triangles.empty()) mesh.positions.emplace_back(0.0f);
  for (glm::vec3& position : mesh.positions) {
    // -0 + 0 = +0: the sign of a zero must not steer a comparison of bits later.
    position = is_finite(position) ? position + 0.0f : glm::vec3(0.0f);
  }
  replace_non_finite<3>(mesh.normals, glm::vec3(0.0f), "normals", mesh_index, faults);
  replace_non_finite<4>(mesh.tangents, glm::vec4(0.0f), "tangents", mesh_index, faults);
  replace_non_finite<4>(mesh.colors, glm::vec4(1.0f), "colours", mesh_index, faults);
  for (std::vector<glm::vec2>& uvs : mesh.uvs) {
    replace_non_finite<2>(uvs, glm::vec2(0.0f), "texture coordinates", mesh_index, faults);
    tell_coarse_uvs(uvs, mesh_index, faults);
  }
}

}  // namespace vernier
