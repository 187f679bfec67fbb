#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "bvh/bvh.h"

namespace vernier {

/// Takes those out of `triangles` that lie exactly on an opaque one before them: the same bits in the same corners.
/// Every ray has the same t at both, the lower number wins and lets nothing through, so no picture tells the
/// difference; without this a ray would have to be tested against all of them. Order and ids stay, and triangles
/// without area, which build_bvh leaves out. Returns how many were taken out. `not_opaque(id)` as in build_bvh,
/// `thread_count` too; the result is the same for every one. Fewer than 2^31 triangles. O(n); 16 to 32 bytes per
/// triangle while it runs.
std::size_t remove_hidden(std::vector<BvhTriangle>& triangles, const std::function<bool(std::uint32_t)>& not_opaque,
                          unsigned thread_count);

}  // namespace vernier
