#pragma once

#include <cstdint>

#include "bvh/lanes.h"

namespace vernier {

/// Cubic cells over the doubled centres of triangles, 2^21 along the longest side.
class MortonGrid {
 public:
  /// `centres` bounds the doubled centres that are asked for; finite, of any size.
  explicit MortonGrid(const LaneBox& centres);

  /// 63 bits, those of the cell's x, y and z in turn from the highest down, so that neighbours in this order are
  /// neighbours in space (Morton 1966; Karras 2012, Maximizing Parallelism in the Construction of BVHs, section 2).
  /// `centre` lies within the grid; lane 3 is ignored.
  std::uint64_t code(Lanes centre) const;

 private:
  Lanes origin_;
  float stretch_;
  float scale_;
};

}  // namespace vernier
