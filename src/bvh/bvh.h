#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>

#include "bvh/large_array.h"

namespace vernier {

/// Axis-aligned box; empty while lo > hi. Growing by an empty box changes nothing.
struct Box {
  glm::vec3 lo = glm::vec3(3.0e38f);
  glm::vec3 hi = glm::vec3(-3.0e38f);
};

/// Corners of one triangle, in the space that is traced (see pack_scene). `id` is the triangle's global number.
struct BvhTriangle {
  glm::vec3 v0, v1, v2;
  std::uint32_t id;
};

/// 48 bytes of the device array that is traversed: a node with four quantised child boxes or one triangle.
/// Layout: shared/bvh_record.h.
using BvhRecord = std::array<std::uint32_t, 12>;

/// A bounding volume hierarchy of degree 4 in device layout. records[0] is the root; the children of a node are
/// contiguous. Empty when there is no triangle.
struct Bvh {
  LargeArray<BvhRecord> records;
  Box bounds;  ///< unpadded bounds of the triangles in the tree
  std::uint32_t triangle_count = 0;
  std::uint32_t node_count = 0;      ///< instances too
  std::uint32_t instance_count = 0;  ///< of trees in the tree (instance_tree.h)
  bool coarse = false;               ///< rays may pad all boxes by one bound each (coarse.h)
  /// Nodes on the longest way from the root to a triangle: the root over triangles has depth 1. Below an instance its
  /// tree's own nodes count on. A traversal that keeps the unvisited siblings of one level as one group, and pushes the
  /// group it holds when it goes down a level, pushes nothing at the root and once at most at each further node: depth
  /// - 1 stack entries always do.
  std::uint32_t depth = 0;
  double sah_cost =
      0.0;  ///< of the binary tree before collapsing: sum of area(node)/area(root) x (1 + triangles in a leaf)
};

}  // namespace vernier
