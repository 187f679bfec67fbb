#pragma once

#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <map>
#include <utility>
#include <vector>

#include "bvh/bvh.h"

namespace vernier::shader {

/// A closed mesh around the origin, star-shaped, with sharp and flat edges.
struct ClosedMesh {
  std::vector<glm::vec3> positions;
  std::vector<glm::uvec3> triangles;
};

/// An octahedron whose triangles are cut in four `levels` times, each vertex moved out to a radius in [0.8, 1.2) that
/// its number decides.
inline ClosedMesh bumpy_sphere(int levels) {
  ClosedMesh mesh;
  mesh.positions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  mesh.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto [entry, is_new] =
          middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(mesh.positions.size()));
      if (is_new) mesh.positions.push_back(glm::normalize(mesh.positions[a] + mesh.positions[b]));
      return entry->second;
    };
    std::vector<glm::uvec3> finer;
    for (const glm::uvec3& t : mesh.triangles) {
      const std::uint32_t ab = middle(t.x, t.y), bc = middle(t.y, t.z), ca = middle(t.z, t.x);
      finer.insert(finer.end(), {{t.x, ab, ca}, {ab, t.y, bc}, {ca, bc, t.z}, {ab, bc, ca}});
    }
    mesh.triangles = std::move(finer);
  }
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const double turn = std::fmod(static_cast<double>(i) * 0.6180339887498949, 1.0);
    mesh.positions[i] *= static_cast<float>(0.8 + 0.4 * turn);
  }
  return mesh;
}

/// The mesh's triangles, times `scale` and moved by `offset`.
inline std::vector<BvhTriangle> corners_of(const ClosedMesh& mesh, float scale, const glm::vec3& offset) {
  std::vector<BvhTriangle> corners;
  for (const glm::uvec3& t : mesh.triangles) {
    corners.push_back({mesh.positions[t.x] * scale + offset, mesh.positions[t.y] * scale + offset,
                       mesh.positions[t.z] * scale + offset, static_cast<std::uint32_t>(corners.size())});
  }
  return corners;
}

}  // namespace vernier::shader
