#include "bvh/triangle_record.h"

#include <string>

#include "bvh/box.h"
#include "bvh/zero_area.h"
#include "error.h"
#include "shared/bvh_record.h"

namespace vernier {

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
