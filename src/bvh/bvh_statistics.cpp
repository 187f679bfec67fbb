#include "bvh/bvh_statistics.h"

#include "bvh/box.h"
#include "bvh/decode_record.h"

namespace vernier {

BvhStatistics bvh_statistics(const Bvh& bvh) {
  BvhStatistics statistics;
  if (bvh.records.empty()) {
    return statistics;
  }
  statistics.depth = bvh.depth;
  statistics.bytes = bvh.records.size() * sizeof(BvhRecord);
  statistics.sah_cost = bvh.sah_cost;
  double area_sum = half_area(bvh.bounds);
  std::size_t child_count = 0;
  for (const BvhRecord& record : bvh.records) {
    if (is_triangle(record)) {
      ++statistics.triangle_count;
      continue;
    }
    ++statistics.node_count;
    const DecodedNode node = decode_node(record);
    child_count += node.child_count;
    for (std::uint32_t i = 0; i < node.child_count; ++i) {
      const glm::dvec3 side = node.boxes[i].hi - node.boxes[i].lo;
      area_sum += side.x * side.y + side.y * side.z + side.z * side.x;
    }
  }
  statistics.wide_cost = area_sum / half_area(bvh.bounds);
  statistics.mean_child_count = static_cast<double>(child_count) / statistics.node_count;
  return statistics;
}

}  // namespace vernier
