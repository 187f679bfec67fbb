#include "effects/used_materials.h"

namespace vernier {
namespace {

bool two_corners_coincide(const Mesh& mesh, const glm::uvec3& corners) {
  const glm::vec3& p0 = mesh.positions[corners.x];
  const glm::vec3& p1 = mesh.positions[corners.y];
  const glm::vec3& p2 = mesh.positions[corners.z];
  return p0 == p1 || p1 == p2 || p2 == p0;
}

bool has_corner_normals(const Mesh& mesh, const glm::uvec3& corners) {
  const glm::vec3 none(0.0f);
  return !mesh.normals.empty() && mesh.normals[corners.x] != none && mesh.normals[corners.y] != none &&
         mesh.normals[corners.z] != none;
}

void add_usage(const Mesh& mesh, std::vector<MaterialUsage>& usage) {
  for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
    const glm::uvec3& corners = mesh.triangles[triangle];
    if (two_corners_coincide(mesh, corners)) {
      continue;
    }
    MaterialUsage& material = usage[mesh.triangle_materials[triangle]];
    material.used = true;
    material.vertex_colors = material.vertex_colors || !mesh.colors.empty();
    material.vertex_normals = material.vertex_normals || has_corner_normals(mesh, corners);
  }
}

}  // namespace

std::vector<MaterialUsage> used_materials(const Scene& scene) {
  std::vector<bool> placed(scene.meshes.size(), false);
  for (const Instance& instance : scene.instances) {
    placed[instance.mesh] = true;
  }
  std::vector<MaterialUsage> usage(scene.materials.size());
  for (std::size_t mesh = 0; mesh < scene.meshes.size(); ++mesh) {
    if (placed[mesh]) {
      add_usage(scene.meshes[mesh], usage);
    }
  }
  return usage;
}

}  // namespace vernier
