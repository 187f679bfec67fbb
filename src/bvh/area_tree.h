#pragma once

#include "bvh/binary_tree.h"
#include "bvh/triangle_reference.h"
#include "math/thread_team.h"

namespace vernier {

/// Makes the references.all.size() - 1 `nodes` of a tree over two or more `references`, which are put in another order,
/// numbered as BinaryTree says: each range is split where the surface area heuristic is least between 16 bins on
/// each axis, by medians from depth kMedianDepth on. The same for every `team`. `done` as in build_binary_tree.
void fill_nodes_by_area(const TriangleReferences& references, BinaryNode* nodes, ThreadTeam& team,
                        const CountDone& done);

}  // namespace vernier
