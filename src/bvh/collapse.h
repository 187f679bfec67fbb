#pragma once

#include <array>
#include <cstdint>

#include "bvh/binary_tree.h"
#include "bvh/large_array.h"

namespace vernier {

/// Children of a node of the device tree.
inline constexpr std::uint32_t kMaxChildren = 4;

/// The cheapest way to hand a binary subtree to a wide parent as at most 1, 2 or 3 children: the sum of the areas of
/// the wide nodes needed, relative to the root's, and how many records they and the triangles take.
struct CollapsePlan {
  std::array<float, kMaxChildren - 1> cost;
  std::array<std::uint32_t, kMaxChildren - 1> record_count;
};

/// Plans for every binary node, by its number.
using CollapsePlans = LargeArray<CollapsePlan>;

/// Finds the collapse to degree 4 whose nodes have the least sum of areas, by dynamic programming from the leaves up
/// (after Ylitie, Karras, Laine 2017, Efficient Incoherent Ray Traversal on GPUs Through Compressed Wide BVHs, 3.1;
/// here every leaf stays one triangle). At least two triangles. The same for every `thread_count`. 24 bytes per
/// triangle.
CollapsePlans plan_collapse(const BinaryTree& tree, unsigned thread_count);

/// Records of the subtree below `child` when it is one child of a wide node, itself included.
inline std::uint32_t record_count(const CollapsePlans& plans, BinaryChild child) {
  return is_leaf(child) ? 1 : plans[child].record_count[0];
}

/// Children of one wide node, left to right, with the number of triangles below each.
struct WideChildren {
  struct Child {
    BinaryChild child;
    std::uint32_t leaf_count;
  };
  std::array<Child, kMaxChildren> children;
  std::uint32_t count = 0;
};

/// The children that the plans give to the wide node that stands for binary node `node` with `leaf_count` triangles.
WideChildren wide_children(const BinaryTree& tree, const CollapsePlans& plans, std::uint32_t node,
                           std::uint32_t leaf_count);

}  // namespace vernier
