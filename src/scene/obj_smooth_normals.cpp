#include "scene/obj_smooth_normals.h"

#include <algorithm>
#include <cmath>

namespace vernier {
namespace {

bool needs_smoothing(const ObjTriangle& triangle) {
  return triangle.smoothing_group != 0 &&
         std::ranges::any_of(triangle.corners, [](const ObjCorner& corner) { return corner.normal < 0; });
}

// Of edges scaled to length 1 first: the product of two tiny edges would vanish.
double angle_between(const glm::dvec3& a, const glm::dvec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

glm::dvec3 unit_or_zero(const glm::dvec3& v) {
  const double size = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (!(size > 0.0) || !std::isfinite(size)) return glm::dvec3(0.0);
  return glm::normalize(v / size);
}

void add_triangle(const ObjGeometry& geometry, const ObjTriangle& triangle, SmoothNormals& sums) {
  std::array<glm::dvec3, 3> p;
  for (std::size_t i = 0; i < 3; ++i) p[i] = geometry.positions[static_cast<std::size_t>(triangle.corners[i].position)];
  const std::array<glm::dvec3, 3> edges = {unit_or_zero(p[1] - p[0]), unit_or_zero(p[2] - p[1]),
                                           unit_or_zero(p[0] - p[2])};
  const glm::dvec3 normal = unit_or_zero(glm::cross(edges[0], -edges[2]));
  for (std::size_t i = 0; i < 3; ++i) {
    const double angle = angle_between(edges[i], -edges[(i + 2) % 3]);
    glm::dvec3& sum = sums[smooth_normal_key(triangle.corners[i].position, triangle.smoothing_group)];
    sum += angle * normal;
  }
}

}  // namespace

SmoothNormals smooth_normals(const ObjGeometry& geometry) {
  SmoothNormals normals;
  for (const ObjShape& shape : geometry.shapes) {
    for (const ObjTriangle& triangle : shape.triangles) {
      if (needs_smoothing(triangle)) add_triangle(geometry, triangle, normals);
    }
  }
  for (auto& [key, normal] : normals) normal = unit_or_zero(normal);
  return normals;
}

}  // namespace vernier
