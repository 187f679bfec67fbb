#pragma once

#include <span>

#include "bvh/split.h"

namespace vernier {

/// Splits two or more `references` into halves (of an odd number the left one is larger by one) by the
/// centre on the axis where the centres, bounded by `bounds`, spread most; equal centres by the triangle's index.
/// So a range of n is down to single references after ceil(log2 n) splits, whatever the input.
Split split_by_median(std::span<TriangleReference> references, const ReferenceBounds& bounds);

}  // namespace vernier
