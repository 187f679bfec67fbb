#pragma once

#include <span>

#include "bvh/bvh.h"

namespace vernier::test {

/// SAH cost (as in Bvh) of the tree that a plain builder makes: at every node all splits of all three orders by
/// centre are tried, one triangle per leaf. No bins, no cleverness; O(n log^2 n). All triangles have area.
double naive_sah_cost(std::span<const BvhTriangle> triangles);

}  // namespace vernier::test
