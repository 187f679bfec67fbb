#pragma once

#include <bit>
#include <cstdint>
#include <glm/glm.hpp>

#include "bvh/bvh.h"

namespace vernier {

/// x, y, z and one free lane in a vector register (an extension of GCC and Clang, on every processor they know).
using Lanes = float __attribute__((vector_size(16)));
using IntLanes = std::int32_t __attribute__((vector_size(16)));

/// Lane by lane the smaller of two.
inline Lanes lanes_min(Lanes a, Lanes b) {
  return a < b ? a : b;
}
/// Lane by lane the larger of two.
inline Lanes lanes_max(Lanes a, Lanes b) {
  return a > b ? a : b;
}
/// x, y, z and 0.
inline Lanes lanes_from(const glm::vec3& v) {
  return Lanes{v.x, v.y, v.z, 0.0f};
}
/// The first three lanes.
inline glm::vec3 vec3_from(Lanes v) {
  return {v[0], v[1], v[2]};
}
/// `v` with lane 3 set to 0: an integer kept there reads as a denormal float, which is slow to calculate with.
inline Lanes without_lane_3(Lanes v) {
  return std::bit_cast<Lanes>(std::bit_cast<IntLanes>(v) & IntLanes{-1, -1, -1, 0});
}

/// Box in two registers, lane 3 free. Empty by default; growing by an empty one changes nothing.
struct LaneBox {
  Lanes lo = {3.0e38f, 3.0e38f, 3.0e38f, 3.0e38f};
  Lanes hi = {-3.0e38f, -3.0e38f, -3.0e38f, -3.0e38f};

  /// Grows the box to hold [other_lo, other_hi].
  void grow(Lanes other_lo, Lanes other_hi) {
    lo = lanes_min(lo, other_lo);
    hi = lanes_max(hi, other_hi);
  }
  /// Grows the box to hold `other`.
  void grow(const LaneBox& other) { grow(other.lo, other.hi); }
};

/// Four floats from `first` on, which need not be aligned.
inline Lanes load_lanes(const float* first) {
  Lanes lanes;
  __builtin_memcpy(&lanes, first, sizeof lanes);
  return lanes;
}

/// The same box in registers, lane 3 set to 0.
inline LaneBox lane_box(const Box& box) {
  const Lanes from_lo_z = load_lanes(&box.lo.z);
  return {without_lane_3(load_lanes(&box.lo.x)),
          without_lane_3(__builtin_shufflevector(from_lo_z, from_lo_z, 1, 2, 3, 0))};
}

/// Bounds of the three corners, lane 3 set to 0.
inline LaneBox lane_box(const BvhTriangle& triangle) {
  // What follows a corner in memory, a coordinate or the id, falls into lane 3.
  const Lanes v0 = load_lanes(&triangle.v0.x), v1 = load_lanes(&triangle.v1.x), v2 = load_lanes(&triangle.v2.x);
  return {without_lane_3(lanes_min(lanes_min(v0, v1), v2)), without_lane_3(lanes_max(lanes_max(v0, v1), v2))};
}

/// The same box in plain floats.
inline Box box_from(const LaneBox& box) {
  return {vec3_from(box.lo), vec3_from(box.hi)};
}

/// Half the surface of `box` times scale squared. Meaningless for an empty box: ask only for those that hold something.
inline float scaled_half_area(const LaneBox& box, float scale) {
  // Lane 3 may hold a triangle's index, as a float a denormal, and those Intel's CPUs multiply slowly.
  const Lanes side = without_lane_3(box.hi - box.lo) * scale;
  const Lanes products = side * __builtin_shufflevector(side, side, 1, 2, 0, 3);
  return products[0] + products[1] + products[2];
}

}  // namespace vernier
