#pragma once

#include <span>

#include "bvh/split.h"

namespace vernier {

/// Up to this many references every split of the three sorted orders is tried; more go through bins.
inline constexpr std::size_t kSweepLimit = 8;

/// Splits 2 to kSweepLimit `references` where the surface area heuristic is least among all splits of their orders by
/// centre on the three axes (equal centres keep their order), and puts them in that order.
/// `area_scale` is about 1 / the longest side of the scene.
Split split_by_sweep(std::span<TriangleReference> references, float area_scale);

}  // namespace vernier
