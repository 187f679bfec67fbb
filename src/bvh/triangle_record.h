#pragma once

#include <functional>
#include <span>

#include "bvh/bvh.h"

namespace vernier {

/// `triangle` as a record. `not_opaque` sets BVH_TRIANGLE_NOT_OPAQUE.
BvhRecord triangle_record(const BvhTriangle& triangle, bool not_opaque);

/// `triangles` as records in their order with no node above them, for a tree that the driver builds (BoxTree). Left out
/// are those that build_bvh leaves out; `not_opaque` as there, but called by this thread alone. Throws Error(refused)
/// for more than BVH_MAX_RECORDS triangles.
Bvh list_triangles(std::span<const BvhTriangle> triangles, const std::function<bool(std::uint32_t)>& not_opaque);

}  // namespace vernier
