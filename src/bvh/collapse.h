#pragma once

#include <array>
#include <cstdint>

#include "bvh/binary_tree.h"
#include "bvh/large_array.h"
#include "math/thread_team.h"

namespace vernier {

/// Children of a node of the device tree.
inline constexpr std::uint32_t kMaxChildren = 4;

/// The cheapest way to hand a binary subtree to a wide parent as at most 1, 2 or 3 children, in one word.
struct CollapsePlan {
  /// In the upper 26 bits records_of_one, below them left_slots of 4, 3 and 2 slots, two bits each.
  std::uint32_t bits;
};

/// Records of the subtree as one child: its wide nodes and its triangles.
inline std::uint32_t records_of_one(CollapsePlan plan) {
  return plan.bits >> 6;
}

/// How many of `slots` (2 to 4) children the left side gets of a node that is opened for so many, the right side gets
/// the others; 0 where the node had better be handed over as fewer.
inline std::uint32_t left_slots(CollapsePlan plan, std::uint32_t slots) {
  return plan.bits >> 2 * (slots - 2) & 3;
}

/// Plans for every binary node, by its number.
using CollapsePlans = LargeArray<CollapsePlan>;

/// Finds the collapse to degree 4 whose nodes have the least sum of areas, by dynamic programming from the leaves up
/// (after Ylitie, Karras, Laine 2017, Efficient Incoherent Ray Traversal on GPUs Through Compressed Wide BVHs, 3.1;
/// here every leaf stays one triangle). At least two triangles, 2^24 at most. The same for every `team`. 4
/// bytes per triangle.
CollapsePlans plan_collapse(const BinaryTree& tree, ThreadTeam& team);

/// Records of the subtree below `child` when it is one child of a wide node, itself included.
inline std::uint32_t record_count(const CollapsePlans& plans, BinaryChild child) {
  return is_leaf(child) ? 1 : records_of_one(plans[child]);
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
