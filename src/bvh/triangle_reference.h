#pragma once

#include <cstdint>
#include <span>

#include "bvh/lanes.h"
#include "bvh/workspace.h"
#include "math/thread_team.h"

namespace vernier {

/// What the builder moves about instead of a triangle: its box and where it stands in the input. 32 bytes.
struct TriangleReference {
  Lanes lo;  ///< lane 3 holds the bits of the triangle's index
  Lanes hi;  ///< lane 3 is 0
};

/// Index of the triangle in the input.
inline std::uint32_t triangle_index(const TriangleReference& reference) {
  return std::bit_cast<IntLanes>(reference.lo)[3];
}

/// Twice the centre of the box; lane 3 is 0.
inline Lanes doubled_centre(const TriangleReference& reference) {
  return without_lane_3(reference.lo) + reference.hi;
}

/// Bounds of some references and of their doubled centres.
struct ReferenceBounds {
  LaneBox box;
  LaneBox centres;

  /// Grows by one reference.
  void grow(const TriangleReference& reference) {
    const Lanes centre = doubled_centre(reference);
    box.grow(reference.lo, reference.hi);
    centres.grow(centre, centre);
  }
};

/// Bounds of `references`; empty boxes for none.
ReferenceBounds bounds_of(std::span<const TriangleReference> references);

/// References to all triangles that have area, in input order.
struct TriangleReferences {
  std::span<TriangleReference> all;
  ReferenceBounds bounds;
  double half_area_sum = 0.0;  ///< of the triangles' boxes, added in the same order for every thread count
  std::size_t fine_count = 0;  ///< triangles that is_fine holds for (coarse.h)
};

/// Makes the references on the threads of `team` in 32 bytes of `workspace` per triangle. Fewer than 2^31 triangles
/// with finite coordinates.
TriangleReferences make_references(std::span<const BvhTriangle> triangles, ThreadTeam& team, Workspace& workspace);

}  // namespace vernier
