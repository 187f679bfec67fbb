#pragma once

#include "bvh/binary_tree.h"
#include "bvh/triangle_reference.h"
#include "math/thread_team.h"

namespace vernier {

/// Makes the references.all.size() - 1 `nodes` of a tree over two or more `references`, numbered as BinaryTree says, by
/// the order of their Morton codes: a range is split where the highest bit changes in which its codes differ
/// (Lauterbach et al. 2009, Fast BVH Construction on GPUs), or in its middle where they are equal or the depth is
/// kMedianDepth. No heuristic looks at areas: several times quicker than fill_nodes_by_area, and the tree is somewhat
/// dearer. The same for every `team`. `done` as in build_binary_tree. 32 bytes of `workspace` per
/// reference.
void fill_nodes_by_code(const TriangleReferences& references, BinaryNode* nodes, ThreadTeam& team, Workspace& workspace,
                        const CountDone& done);

}  // namespace vernier
