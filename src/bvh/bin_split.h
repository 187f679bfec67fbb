#pragma once

#include <optional>
#include <span>

#include "bvh/split.h"
#include "math/thread_team.h"

namespace vernier {

/// Splits two or more `references` with `bounds` where the surface area heuristic is least (16 bins on each of three
/// axes: Wald 2007, On fast Construction of SAH-based Bounding Volume Hierarchies) and puts them in order.
/// Nothing when all centres fall into one bin on every axis: they coincide, or lie closer than 1e-36.
/// `area_scale` is about 1 / the longest side of the scene. `team` helps where it is not null;
/// the result is the same for every one.
std::optional<Split> split_by_bins(std::span<TriangleReference> references, const ReferenceBounds& bounds,
                                   float area_scale, ThreadTeam* team);

}  // namespace vernier
