#pragma once

#include <span>

#include "bvh/split.h"

namespace vernier {

/// Splits two or more `references` where the surface area heuristic is least among all splits of their orders by centre
/// on the three axes (equal centres by the triangle's index), and puts them in that order. O(n log n), 4 bytes per
/// reference while it runs. `area_scale` is about 1 / the longest side of the scene.
Split split_by_sorting(std::span<TriangleReference> references, float area_scale);

}  // namespace vernier
