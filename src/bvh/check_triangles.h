#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "bvh/bvh.h"

namespace vernier {

/// Ticks off the triangles of a tree against the input they were made from.
class TriangleTally {
 public:
  /// `triangles` is kept by reference. O(n) where their ids rise, O(n log n) otherwise.
  explicit TriangleTally(std::span<const BvhTriangle> triangles);

  /// Ticks off the triangle record number `record_index`. The first fault in words: a free word that is not 0, an id
  /// that is not in the input or was seen before, corners that differ in a bit, no area. Empty when there is none.
  std::string tick(const BvhRecord& record, std::uint32_t record_index);

  /// Names a triangle that has area and was not ticked off, or an id that occurs twice. Empty when there is none.
  std::string first_left_over() const;

 private:
  std::span<const BvhTriangle> triangles_;
  std::vector<std::uint32_t> by_id_;  // indices of triangles_, ids rising
  std::vector<bool> seen_;
};

}  // namespace vernier
