#pragma once

#include <bit>
#include <functional>
#include <span>

#include "bvh/bvh.h"
#include "shared/bvh_record.h"

namespace vernier {

/// `triangle` as a record. `not_opaque` sets BVH_TRIANGLE_NOT_OPAQUE.
inline BvhRecord triangle_record(const BvhTriangle& triangle, bool not_opaque) {
  const auto bits = [](float value) { return std::bit_cast<std::uint32_t>(value); };
  return {bits(triangle.v0.x), bits(triangle.v0.y),
          bits(triangle.v0.z), BVH_TRIANGLE | (not_opaque ? BVH_TRIANGLE_NOT_OPAQUE : 0u) | BVH_VERTEX_BITS(0u),
          bits(triangle.v1.x), bits(triangle.v1.y),
          bits(triangle.v1.z), 0u,
          bits(triangle.v2.x), bits(triangle.v2.y),
          bits(triangle.v2.z), triangle.id};
}

/// `triangles` as records in their order with no node above them, for a tree that the driver builds (DriverTree). Left
/// out are those that build_bvh leaves out; `not_opaque` as there, but called by this thread alone. Throws
/// Error(refused) for more than BVH_MAX_RECORDS triangles.
Bvh list_triangles(std::span<const BvhTriangle> triangles, const std::function<bool(std::uint32_t)>& not_opaque);

}  // namespace vernier
