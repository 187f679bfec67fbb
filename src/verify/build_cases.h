#pragma once

#include "verify/verify_case.h"

namespace vernier {

// Meshes that are hard to build a BVH over, and scenes on their way into the traced space.

/// 7: scenes scaled by 2^-70 to 2^66: the same hits, to the bit.
CaseResult run_scale(const CaseSetup& setup);
/// 27: meshes of random bits with indices out of range: repaired, packed and traced to an end.
CaseResult run_garbage_mesh(const CaseSetup& setup);
/// 28: concentric and identical triangles: no deep tree, and the same hits as without one.
CaseResult run_identical_centroids(const CaseSetup& setup);
/// 29: sizes in a geometric series and long sticks: the stack suffices.
CaseResult run_deep_tree(const CaseSetup& setup);
/// 31: the order in which triangles come to the builder changes no bit of a hit.
CaseResult run_build_order(const CaseSetup& setup);
/// 34: an instance that mirrors gives the same bits as a mirrored mesh.
CaseResult run_mirror(const CaseSetup& setup);

}  // namespace vernier
