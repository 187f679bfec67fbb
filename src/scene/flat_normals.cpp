#include "scene/flat_normals.h"

#include <algorithm>

namespace vernier {
namespace {

// Sine of the angle that an interpolated normal is off by through its own rounding: two sums, a product and the scaling
// to length 1, each 2^-24.
constexpr double kInterpolation = 0x1p-22;

bool is_flat(const Mesh& mesh, const glm::uvec3& corners) {
  const glm::dvec3 origin(mesh.positions[corners.x]);
  const glm::dvec3 cross =
      glm::cross(glm::dvec3(mesh.positions[corners.y]) - origin, glm::dvec3(mesh.positions[corners.z]) - origin);
  const double length = glm::length(cross);
  if (!(length > 0.0)) return length == 0.0;  // never hit
  const double side = glm::dot(cross, glm::dvec3(mesh.normals[corners.x])) < 0.0 ? -1.0 : 1.0;
  for (const std::uint32_t corner : {corners.x, corners.y, corners.z}) {
    const glm::dvec3 off = glm::dvec3(mesh.normals[corner]) - cross * (side / length);
    if (!(glm::length(off) <= kInterpolation)) return false;
  }
  return true;
}

}  // namespace

void drop_flat_normals(Scene& scene) {
  for (Mesh& mesh : scene.meshes) {
    if (mesh.normals.empty()) continue;
    mesh.flat_normals = std::ranges::all_of(mesh.triangles, [&](const glm::uvec3& one) { return is_flat(mesh, one); });
    if (mesh.flat_normals) mesh.normals.clear();
  }
}

}  // namespace vernier
