#pragma once

#include <functional>
#include <span>

#include "bvh/build_method.h"
#include "bvh/bvh.h"

namespace vernier {

/// Builds a binary tree by `method` on `thread_count` threads (0: all cores), one triangle per leaf, collapses it to
/// degree 4 and encodes it. `not_opaque(id)` sets BVH_TRIANGLE_NOT_OPAQUE; it is called from several threads at once,
/// and what it throws is passed on; an empty function marks nothing. Child boxes are padded outwards by at least
/// 2^-22 max(|lo|, |hi|) over all axes per side, at least 2^-40 of the scene's extent, then quantised outwards.
/// Triangles of zero area (has_zero_area: the float corners lie exactly on a line) are left out. All coordinates are
/// finite, up to 1e30. Touches 110 bytes per triangle at most beside the input, with BuildMethod::quality 220; 70
/// remain. `progress(share)`, in [0, 1], is called by any thread, never by two at once, for every few thousand
/// triangles. The result is the same for every thread count. Depth is at most 48 + ceil(log2 n): below depth 48 ranges
/// are halved. Throws Error(refused) when more than BVH_MAX_RECORDS records are needed. No triangle: an empty Bvh.
Bvh build_bvh(std::span<const BvhTriangle> triangles, const std::function<bool(std::uint32_t)>& not_opaque,
              unsigned thread_count, BuildMethod method = BuildMethod::standard,
              const std::function<void(double share)>& progress = {});

}  // namespace vernier
