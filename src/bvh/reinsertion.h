#pragma once

#include <span>

#include "bvh/binary_tree.h"
#include "math/thread_team.h"

namespace vernier {

/// Lowers the sum of the areas of `tree`'s nodes: subtrees are taken out and put in where they enlarge least what they
/// get under, the largest gains first, a few times over (after Meister and Bittner 2018, Parallel Reinsertion for
/// Bounding Volume Hierarchy Optimization; here moves are made one by one, and those that gain nothing any more are
/// taken back). The tree stays as it was where it would get deeper than kMedianDepth and the logarithm of its
/// triangles. The same for every `team`. Takes 140 bytes per triangle.
void reinsert_subtrees(BinaryTree& tree, std::span<const BvhTriangle> triangles, ThreadTeam& team);

}  // namespace vernier
