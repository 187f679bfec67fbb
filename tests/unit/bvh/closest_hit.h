#pragma once

#include <limits>
#include <span>

#include "bvh/bvh.h"

namespace vernier::test {

/// Ray in double.
struct TestRay {
  glm::dvec3 origin, direction;
};

/// Nearest crossing with t > 0; of equal t the lowest id.
struct TestHit {
  double t = std::numeric_limits<double>::infinity();
  std::uint32_t id = 0xffffffffu;
  bool operator==(const TestHit&) const = default;
};

/// What a walk needed.
struct WalkCounts {
  std::uint64_t records = 0;
  std::size_t largest_stack = 0;  ///< most groups that waited at once
};

/// Closest hit by walking the records as the device does: groups of siblings, at most one push per node.
TestHit closest_hit(const Bvh& bvh, const TestRay& ray, WalkCounts& counts);

/// Closest hit by trying every triangle.
TestHit closest_hit_by_brute_force(std::span<const BvhTriangle> triangles, const TestRay& ray);

}  // namespace vernier::test
