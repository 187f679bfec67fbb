#pragma once

#include <functional>
#include <span>
#include <vector>

#include "bvh/bvh.h"

namespace vernier {

/// `triangles` without those that lie exactly on an opaque one before them: the same bits in the same corners. Every
/// ray has the same t at both, the lower number wins and lets nothing through, so no picture tells the difference;
/// without this a ray would have to be tested against all of them. Order and ids stay, and triangles without area,
/// which build_bvh leaves out. `not_opaque(id)` as in build_bvh. O(n).
std::vector<BvhTriangle> without_hidden(std::span<const BvhTriangle> triangles,
                                        const std::function<bool(std::uint32_t)>& not_opaque);

}  // namespace vernier
