#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "bvh/binary_tree.h"
#include "bvh/build_progress.h"
#include "bvh/bvh.h"
#include "bvh/collapse.h"
#include "math/thread_team.h"

namespace vernier {

/// Writes the wide tree of `plans` in device layout: the root, its children side by side, then depth first what is
/// below the first child, the second and so on. See build_bvh for `not_opaque`. A single triangle gets a root of its
/// own (`plans` is not used); an empty tree makes an empty Bvh. `done` is told of triangles as
/// they are written. Records are written to the start of `memory` as far as it is large enough; what it held before is
/// lost. Throws Error(refused) above BVH_MAX_RECORDS records.
Bvh encode_bvh(const BinaryTree& tree, const CollapsePlans& plans, std::span<const BvhTriangle> triangles,
               const std::function<bool(std::uint32_t)>& not_opaque, ThreadTeam& team, const CountDone& done = {},
               LargeArray<BvhRecord> memory = {});

}  // namespace vernier
