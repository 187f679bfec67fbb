#pragma once

#include <cstddef>
#include <glm/glm.hpp>

#include "bvh/box.h"

namespace vernier {

/// What rays move the boxes of a coarse tree outwards by at most (COARSE in shaders/intersect_box.glsl): 10 roundings
/// of 2 x (1 + 4), for rays that start within [-1, 1].
inline constexpr double kCoarsePadding = 0x1p-17;

/// Whether a triangle in `box` is so small that kCoarsePadding adds more than a tenth to the area of its box: a
/// matter of speed alone, as are the 1 in 256 below.
inline bool is_fine(const Box& box) {
  const glm::dvec3 side = glm::dvec3(box.hi) - glm::dvec3(box.lo);
  const double added = 4.0 * kCoarsePadding * (side.x + side.y + side.z) + 12.0 * kCoarsePadding * kCoarsePadding;
  return added > 0.1 * half_area(box);
}

/// Whether `bounds` lie in [-1, 1] and a sixteenth more, which instances may take: what COARSE_REACH in
/// shaders/intersect_box.glsl counts on.
inline bool is_in_coarse_reach(const Box& bounds) {
  const glm::vec3 reach = glm::max(glm::abs(bounds.lo), glm::abs(bounds.hi));
  return std::max(reach.x, std::max(reach.y, reach.z)) <= 1.0625f;
}

/// Whether rays may pad the boxes of a tree of `count` triangles within `bounds` by one bound each: it is in reach, and
/// hardly a triangle (1 in 256) is fine.
inline bool is_coarse(const Box& bounds, std::size_t fine_count, std::size_t count) {
  return is_in_coarse_reach(bounds) && 256 * fine_count <= count;
}

}  // namespace vernier
