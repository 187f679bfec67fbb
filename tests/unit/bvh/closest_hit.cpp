#include "closest_hit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include "bvh/decode_record.h"

namespace vernier::test {
namespace {

// Moeller and Trumbore 1997 in double; edges belong to the triangle.
void intersect(const BvhTriangle& triangle, const TestRay& ray, TestHit& hit) {
  const glm::dvec3 v0(triangle.v0);
  const glm::dvec3 e1 = glm::dvec3(triangle.v1) - v0;
  const glm::dvec3 e2 = glm::dvec3(triangle.v2) - v0;
  const glm::dvec3 p = glm::cross(ray.direction, e2);
  const double determinant = glm::dot(e1, p);
  if (determinant == 0.0) {
    return;
  }
  const glm::dvec3 s = ray.origin - v0;
  const glm::dvec3 q = glm::cross(s, e1);
  const double u = glm::dot(s, p) / determinant;
  const double v = glm::dot(ray.direction, q) / determinant;
  const double t = glm::dot(e2, q) / determinant;
  if (u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > 0.0 && (t < hit.t || (t == hit.t && triangle.id < hit.id))) {
    hit = {t, triangle.id};
  }
}

// Entry into the box, or infinity for a miss. Directions of 0 are judged by the origin.
double entry(const DecodedBox& box, const TestRay& ray, double t_max) {
  double t_near = 0.0;
  double t_far = t_max;
  for (int axis = 0; axis < 3; ++axis) {
    if (ray.direction[axis] == 0.0) {
      if (ray.origin[axis] < box.lo[axis] || ray.origin[axis] > box.hi[axis]) {
        return std::numeric_limits<double>::infinity();
      }
      continue;
    }
    const double a = (box.lo[axis] - ray.origin[axis]) / ray.direction[axis];
    const double b = (box.hi[axis] - ray.origin[axis]) / ray.direction[axis];
    t_near = std::max(t_near, std::min(a, b));
    t_far = std::min(t_far, std::max(a, b));
  }
  return t_near <= t_far ? t_near : std::numeric_limits<double>::infinity();
}

// Children of one node that are still to be visited, the nearest last.
struct Group {
  std::array<std::uint32_t, 4> records{};
  std::size_t count = 0;
};

Group children_hit(const DecodedNode& node, const TestRay& ray, double t_max) {
  // Slots that stay unused sort last.
  std::array<std::pair<double, std::uint32_t>, 4> entries;
  entries.fill({-1.0, 0u});
  std::size_t count = 0;
  for (std::uint32_t i = 0; i < node.child_count; ++i) {
    const double t = entry(node.boxes[i], ray, t_max);
    if (t <= t_max && std::isfinite(t)) {
      entries[count++] = {t, node.child_base + i};
    }
  }
  std::sort(entries.begin(), entries.end(), std::greater<>());
  Group group;
  for (std::size_t i = 0; i < count; ++i) {
    group.records[group.count++] = entries[i].second;
  }
  return group;
}

}  // namespace

TestHit closest_hit(const Bvh& bvh, const TestRay& ray, WalkCounts& counts) {
  TestHit hit;
  if (bvh.records.empty()) {
    return hit;
  }
  std::vector<Group> stack;
  Group group{{0}, 1};
  while (group.count > 0) {
    const BvhRecord& record = bvh.records[group.records[--group.count]];
    ++counts.records;
    if (is_triangle(record)) {
      intersect(decode_triangle(record), ray, hit);
    } else {
      const Group below = children_hit(decode_node(record), ray, hit.t);
      if (below.count > 0) {
        if (group.count > 0) {
          stack.push_back(group);
        }
        group = below;
      }
    }
    counts.largest_stack = std::max(counts.largest_stack, stack.size());
    if (group.count == 0 && !stack.empty()) {
      group = stack.back();
      stack.pop_back();
    }
  }
  return hit;
}

TestHit closest_hit_by_brute_force(std::span<const BvhTriangle> triangles, const TestRay& ray) {
  TestHit hit;
  for (const BvhTriangle& triangle : triangles) {
    intersect(triangle, ray, hit);
  }
  return hit;
}

}  // namespace vernier::test
