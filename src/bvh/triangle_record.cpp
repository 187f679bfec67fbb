#include "bvh/triangle_record.h"

#include <bit>
#include <string>

#include "bvh/box.h"
#include "bvh/zero_area.h"
#include "error.h"
#include "shared/bvh_record.h"

namespace vernier {

BvhRecord triangle_record(const BvhTriangle& triangle, bool not_opaque) {
  const auto bits = [](float value) { return std::bit_cast<std::uint32_t>(value); };
  return {bits(triangle.v0.x), bits(triangle.v0.y),
          bits(triangle.v0.z), BVH_TRIANGLE | (not_opaque ? BVH_TRIANGLE_NOT_OPAQUE : 0u),
          bits(triangle.v1.x), bits(triangle.v1.y),
          bits(triangle.v1.z), 0u,
          bits(triangle.v2.x), bits(triangle.v2.y),
          bits(triangle.v2.z), triangle.id};
}

Bvh list_triangles(std::span<const BvhTriangle> triangles, const std::function<bool(std::uint32_t)>& not_opaque) {
  if (triangles.size() > BVH_MAX_RECORDS) {
    throw Error(ErrorKind::refused, "scene: " + std::to_string(triangles.size()) + " triangles, more than " +
                                        std::to_string(BVH_MAX_RECORDS) + " records; simplify or split the model");
  }
  Bvh bvh;
  bvh.records.reserve(triangles.size());
  for (const BvhTriangle& triangle : triangles) {
    if (has_zero_area(triangle.v0, triangle.v1, triangle.v2)) continue;
    bvh.records.push_back(triangle_record(triangle, not_opaque && not_opaque(triangle.id)));
    grow(bvh.bounds, triangle_bounds(triangle));
  }
  bvh.triangle_count = static_cast<std::uint32_t>(bvh.records.size());
  return bvh;
}

}  // namespace vernier
