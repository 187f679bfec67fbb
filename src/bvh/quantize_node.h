#pragma once

#include <cstdint>
#include <span>

#include "bvh/lanes.h"

namespace vernier {

/// Exponent bytes never go below this: cells of at least 2^-102 stay normal floats through the traversal's
/// byte * (cell / direction) and its relative error terms, where a device may flush denormals to zero.
inline constexpr std::uint32_t kLeastExponent = 25;

/// The node record for 1 to 4 `children` inside `node` (all padded already, lane 3 finite; coordinates up to 1e38),
/// which stand from record `child_base` on. The grid starts a cell below node.lo, or more where floats are farther
/// apart, and has the least power of two as cell on each axis with which all children end at 255 cells, so bytes are 1
/// to 255 (shared/bvh_record.h says why not 0). lo is rounded down and hi up: the real box origin + byte * cell holds
/// the child's exactly, and is less than a cell larger on each side. Empty slots get lo = 255, hi = 1.
BvhRecord quantize_node(std::span<const LaneBox> children, const LaneBox& node, std::uint32_t child_base);

/// The same for boxes in plain floats.
BvhRecord quantize_node(std::span<const Box> children, const Box& node, std::uint32_t child_base);

}  // namespace vernier
