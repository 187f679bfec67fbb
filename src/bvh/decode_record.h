#pragma once

#include <array>
#include <cstdint>

#include "bvh/bvh.h"

namespace vernier {

/// Is the record a triangle, or else a node?
bool is_triangle(const BvhRecord& record);

/// What a triangle record says; its flags are left out.
BvhTriangle decode_triangle(const BvhRecord& record);

/// Box with the real bounds origin + byte * cell of a child. In double the sum is exact to 2^-53 of its size.
struct DecodedBox {
  glm::dvec3 lo, hi;
};

/// What a node record says. Children beyond child_count have lo > hi.
struct DecodedNode {
  glm::dvec3 cell;
  std::array<DecodedBox, 4> boxes;
  std::array<bool, 4> slot_is_empty;  ///< lo = 255 and hi = 1 on all axes
  std::uint32_t child_base;
  std::uint32_t child_count;  ///< as it stands in the record: 1 to 4 in a sound one
};

/// Decodes any record that is not a triangle, sound or not.
DecodedNode decode_node(const BvhRecord& record);

}  // namespace vernier
