#pragma once

#include <vector>

#include "golden_case.h"

namespace vernier::golden {

/// How many steps of float rounding the primary rays of a pixel keep from the nearest edge of any triangle,
/// [height][width]: the smallest over the `spp` samples (1: the pixel centre); the largest float without edges.
///
/// A step is 2^-24 (t + L): float moves a ray, at distance t from its origin, sideways by a few 2^-24 of the numbers
/// its place is made of: direction times t, and coordinates of up to L metres. The hit can change only where an edge
/// passes the ray, at its closest approach, by less than that shift. Edges behind the hit count too: they cost a few
/// pixels and keep the measure independent of the order of hits.
/// The number of steps: 3 roundings for each of the direction's components and its normalisation, 2 for the
/// translated corner, 2 for the shear and 3 for the edge function, 10 in all; 16 leaves room for the final division.
/// Not covered: surfaces that cross each other nearer to the ray than the shift.
std::vector<float> steps_to_edge(const CaseSetup& setup, std::uint32_t spp);

}  // namespace vernier::golden
