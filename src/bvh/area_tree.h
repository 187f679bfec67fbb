#pragma once

#include "bvh/binary_tree.h"
#include "bvh/triangle_reference.h"

namespace vernier {

/// Makes the references.count - 1 `nodes` of a tree over two or more `references`, which are put in another order,
/// numbered as BinaryTree says: each range is split where the surface area heuristic is least, by medians from depth
/// kMedianDepth on. The same for every `thread_count` (at least 1).
void fill_nodes_by_area(TriangleReferences& references, BinaryNode* nodes, unsigned thread_count);

}  // namespace vernier
