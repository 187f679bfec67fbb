#pragma once

#include <span>
#include <string>

#include "bvh/bvh.h"

namespace vernier {

/// Proves `bvh` against its input: every triangle of non-zero area exactly once with its own corners, children inside
/// their parent's decoded boxes, boxes around their triangles with the promised padding, depth and counts as stated,
/// every record reached, SAH cost within bounds (at most that of one node per triangle) and box area per level not
/// above twice the root's times a factor that the implementation states.
/// Returns the first fault in words, empty when there is none. O(n).
std::string check_bvh(const Bvh& bvh, std::span<const BvhTriangle> triangles);

}  // namespace vernier
