#pragma once

#include <cstdint>
#include <fstream>
#include <glm/glm.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "bvh/bvh.h"

namespace vernier {

/// Triangles as a file of scene_files.write_raw_mesh has them.
struct RawMesh {
  std::vector<glm::vec3> positions;
  std::vector<glm::uvec3> corners;
};

/// Reads two uint32 counts, float32 positions, uint32 corners. Throws std::runtime_error for a file that is cut off.
inline RawMesh read_mesh(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::uint32_t counts[2] = {};
  file.read(reinterpret_cast<char*>(counts), sizeof counts);
  RawMesh mesh;
  mesh.positions.resize(counts[0]);
  mesh.corners.resize(counts[1]);
  file.read(reinterpret_cast<char*>(mesh.positions.data()),
            static_cast<std::streamsize>(sizeof(glm::vec3) * counts[0]));
  file.read(reinterpret_cast<char*>(mesh.corners.data()), static_cast<std::streamsize>(sizeof(glm::uvec3) * counts[1]));
  if (!file) throw std::runtime_error(path + ": is cut off");
  return mesh;
}

/// The triangles of `mesh`, numbered in order, for a BVH.
inline std::vector<BvhTriangle> triangles_of(const RawMesh& mesh) {
  std::vector<BvhTriangle> triangles;
  triangles.reserve(mesh.corners.size());
  for (const glm::uvec3& corner : mesh.corners) {
    const auto id = static_cast<std::uint32_t>(triangles.size());
    triangles.push_back({mesh.positions[corner.x], mesh.positions[corner.y], mesh.positions[corner.z], id});
  }
  return triangles;
}

}  // namespace vernier
