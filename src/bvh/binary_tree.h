#pragma once

#include <cstdint>
#include <span>

#include "bvh/build_method.h"
#include "bvh/build_progress.h"
#include "bvh/bvh.h"
#include "bvh/large_array.h"
#include "bvh/workspace.h"
#include "math/thread_team.h"

namespace vernier {

/// A child of a binary node: a node's number, or a triangle's index in the input with kLeafBit.
using BinaryChild = std::uint32_t;
inline constexpr BinaryChild kLeafBit = 0x80000000u;

/// Is the child a triangle?
inline bool is_leaf(BinaryChild child) {
  return (child & kLeafBit) != 0;
}
/// Index in the input of a child that is a triangle.
inline std::uint32_t leaf_triangle(BinaryChild child) {
  return child & ~kLeafBit;
}

/// Inner node with the unpadded bounds of what is below it.
struct BinaryNode {
  Box box;
  BinaryChild left, right;
};

/// Binary tree with one triangle per leaf. The m - 1 nodes of a subtree of m triangles lie together, the subtree's root
/// first, then those of its left child, then those of its right child.
struct BinaryTree {
  LargeArray<BinaryNode> nodes;  ///< leaf_count - 1 of them
  std::uint32_t leaf_count = 0;  ///< triangles that have area
  BinaryChild root = 0;          ///< meaningless for an empty tree
  Box bounds;
  double sah_cost = 0.0;  ///< see Bvh
  bool coarse = false;    ///< see Bvh
};

/// How many triangles are below the left child of node `node_index`, which has `leaf_count` below itself.
inline std::uint32_t left_leaf_count(const BinaryNode& node, std::uint32_t node_index, std::uint32_t leaf_count) {
  return is_leaf(node.right) ? leaf_count - 1 : node.right - node_index;
}

/// From this depth on ranges are halved: neither areas nor codes keep a split from peeling off one triangle at a time.
inline constexpr std::uint32_t kMedianDepth = 48;

/// Per triangle: references, and codes twice over with BuildMethod::fast.
inline constexpr std::size_t kWorkspaceBytes = 64;

/// Builds the tree over all triangles that have area by `method`, on the threads of `team`; bit-identical for every
/// number of them. `done` is told of triangles that have their place. Fewer than 2^31 triangles with finite
/// coordinates. The nodes are 32 bytes per triangle; `workspace` has kWorkspaceBytes per triangle.
BinaryTree build_binary_tree(std::span<const BvhTriangle> triangles, BuildMethod method, ThreadTeam& team,
                             Workspace workspace, const CountDone& done = {});

}  // namespace vernier
