#include "reference/intersection.h"

#include <algorithm>
#include <cmath>

namespace vernier::reference {

namespace {

double largest_component(const glm::dvec3& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

}  // namespace

ShearedRay::ShearedRay(const Ray& ray, std::uint32_t source, double largest_coordinate)
    : ray_(ray), source_(source), rounding_(0x1p-44 * std::max(largest_coordinate, largest_component(ray.origin))) {
  int main_axis = 0;
  for (int axis = 1; axis < 3; ++axis)
    if (std::abs(ray.direction[axis]) > std::abs(ray.direction[main_axis])) main_axis = axis;
  axes_ = {(main_axis + 1) % 3, (main_axis + 2) % 3, main_axis};
  shear_ = glm::dvec2(ray.direction[axes_.x], ray.direction[axes_.y]) / ray.direction[main_axis];
}

std::optional<Crossing> ShearedRay::plane_crossing(const Triangle& triangle, std::uint32_t id) const {
  if (id == source_ || triangle.normal == glm::dvec3(0.0)) return std::nullopt;
  glm::dvec2 flat[3];
  double depth[3];
  for (int corner = 0; corner < 3; ++corner) {
    const glm::dvec3 seen = triangle.corners[corner] - ray_.origin;
    depth[corner] = seen[axes_.z];
    flat[corner] = glm::dvec2(seen[axes_.x], seen[axes_.y]) - shear_ * depth[corner];
  }
  // Written so that exchanging the ends of an edge negates its number exactly; not glm::determinant.
  const auto edge = [](const glm::dvec2& from, const glm::dvec2& to) { return from.x * to.y - from.y * to.x; };
  const glm::dvec3 areas(edge(flat[1], flat[2]), edge(flat[2], flat[0]), edge(flat[0], flat[1]));
  const double area = areas.x + areas.y + areas.z;
  if (area == 0.0) return std::nullopt;
  const glm::dvec3 weights = areas / area;
  const double t = (weights.x * depth[0] + weights.y * depth[1] + weights.z * depth[2]) / ray_.direction[axes_.z];
  const double height = glm::dot(triangle.corners[0] - ray_.origin, triangle.normal);
  if (!(t > 0.0) || std::abs(height) <= rounding_) return std::nullopt;
  return Crossing{t, weights};
}

std::optional<Crossing> ShearedRay::hit(const Triangle& triangle, std::uint32_t id) const {
  const std::optional<Crossing> crossing = plane_crossing(triangle, id);
  if (!crossing) return std::nullopt;
  const glm::dvec3& weights = crossing->weights;
  return weights.x >= 0.0 && weights.y >= 0.0 && weights.z >= 0.0 ? crossing : std::nullopt;
}

}  // namespace vernier::reference
