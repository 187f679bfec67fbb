#include "bvh/decode_record.h"

#include <bit>
#include <cmath>

#include "shared/bvh_record.h"

namespace vernier {
namespace {

float as_float(std::uint32_t bits) {
  return std::bit_cast<float>(bits);
}

std::uint32_t byte_of(std::uint32_t word, int index) {
  return (word >> (8 * index)) & 0xffu;
}

}  // namespace

bool is_triangle(const BvhRecord& record) {
  return (record[BVH_WORD_FLAGS] & BVH_TRIANGLE) != 0;
}

BvhTriangle decode_triangle(const BvhRecord& record) {
  return {{as_float(record[0]), as_float(record[1]), as_float(record[2])},
          {as_float(record[4]), as_float(record[5]), as_float(record[6])},
          {as_float(record[8]), as_float(record[9]), as_float(record[10])},
          record[BVH_WORD_NUMBER]};
}

DecodedNode decode_node(const BvhRecord& record) {
  // Words of lo and hi, per axis.
  constexpr int kLoWord[3] = {4, 6, 8};
  DecodedNode node{};
  node.child_base = record[BVH_WORD_CHILD_BASE] & BVH_CHILD_BASE_MASK;
  node.child_count = record[BVH_WORD_NUMBER];
  node.slot_is_empty.fill(true);
  for (int axis = 0; axis < 3; ++axis) {
    const double origin = as_float(record[axis]);
    // As the device does it: the byte is the exponent field of a float.
    const double cell = as_float(byte_of(record[BVH_WORD_FLAGS], axis) << 23);
    node.cell[axis] = cell;
    for (int child = 0; child < 4; ++child) {
      const std::uint32_t lo = byte_of(record[kLoWord[axis]], child);
      const std::uint32_t hi = byte_of(record[kLoWord[axis] + 1], child);
      node.boxes[child].lo[axis] = origin + lo * cell;
      node.boxes[child].hi[axis] = origin + hi * cell;
      node.slot_is_empty[child] = node.slot_is_empty[child] && lo == 255 && hi == 1;
    }
  }
  return node;
}

}  // namespace vernier
