#pragma once

#include <cstddef>
#include <cstdint>

#include "bvh/bvh.h"

namespace vernier {

/// Figures of a tree for reports.
struct BvhStatistics {
  std::uint32_t node_count = 0;
  std::uint32_t triangle_count = 0;
  std::uint32_t depth = 0;        ///< nodes on the longest way from the root to a triangle
  std::size_t bytes = 0;          ///< of the device array
  double sah_cost = 0.0;          ///< of the binary tree, see Bvh
  double wide_cost = 0.0;         ///< records a random line through the root's box visits: sum of box area / root area
  double mean_child_count = 0.0;  ///< per node, of at most 4
};

/// Counts and measures a sound tree (check_bvh) from its records. All zero for an empty tree. O(records).
BvhStatistics bvh_statistics(const Bvh& bvh);

}  // namespace vernier
