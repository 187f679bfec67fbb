#pragma once

#include <functional>
#include <span>

#include "bvh/bvh.h"

namespace vernier {

/// Builds a binary tree by binned SAH on `thread_count` threads (0: all cores), one triangle per leaf, collapses it to
/// degree 4 and encodes it. `not_opaque(id)` sets BVH_TRIANGLE_NOT_OPAQUE. Child boxes are padded outwards by
/// 2^-22 max(|lo|, |hi|) per side, at least 2^-40 of the scene's extent, then quantised outwards.
/// Triangles of zero area (exactly, or with collinear corners in float) are left out. All coordinates are finite.
/// The result is the same for every thread count. Depth is at most 48 + ceil(log2 n): below depth 48 splits are medians.
/// Throws Error(refused) when more than BVH_MAX_RECORDS records are needed.
Bvh build_bvh(std::span<const BvhTriangle> triangles, const std::function<bool(std::uint32_t)>& not_opaque,
              unsigned thread_count);

}  // namespace vernier
