#include "bvh/check_triangles.h"

#include <algorithm>
#include <cstring>
#include <numeric>

#include "bvh/decode_record.h"
#include "bvh/zero_area.h"
#include "shared/bvh_record.h"

namespace vernier {
namespace {

bool same_bits(const BvhTriangle& a, const BvhTriangle& b) {
  static_assert(sizeof(BvhTriangle) == 10 * sizeof(float), "no padding to compare");
  return std::memcmp(&a, &b, sizeof(BvhTriangle)) == 0;
}

bool has_no_area(const BvhTriangle& triangle) {
  return has_zero_area(triangle.v0, triangle.v1, triangle.v2);
}

}  // namespace

TriangleTally::TriangleTally(std::span<const BvhTriangle> triangles)
    : triangles_(triangles), by_id_(triangles.size()), seen_(triangles.size(), false) {
  std::iota(by_id_.begin(), by_id_.end(), 0u);
  const auto id_rises = [&](std::uint32_t a, std::uint32_t b) { return triangles_[a].id < triangles_[b].id; };
  if (!std::is_sorted(by_id_.begin(), by_id_.end(), id_rises)) {
    std::stable_sort(by_id_.begin(), by_id_.end(), id_rises);
  }
}

std::string TriangleTally::tick(const BvhRecord& record, std::uint32_t record_index) {
  const BvhTriangle triangle = decode_triangle(record);
  const std::string place =
      "record " + std::to_string(record_index) + ": triangle " + std::to_string(triangle.id) + " ";
  const auto found =
      triangle.id < by_id_.size() && triangles_[by_id_[triangle.id]].id == triangle.id
          ? by_id_.begin() + triangle.id
          : std::lower_bound(by_id_.begin(), by_id_.end(), triangle.id,
                             [&](std::uint32_t index, std::uint32_t id) { return triangles_[index].id < id; });
  if (found == by_id_.end() || triangles_[*found].id != triangle.id) {
    return place + "is not in the input";
  }
  if (seen_[*found]) {
    return place + "occurs twice";
  }
  seen_[*found] = true;
  if (!same_bits(triangle, triangles_[*found])) {
    return place + "has not the corners of the input";
  }
  if (has_no_area(triangle)) {
    return place + "has no area";
  }
  return record[BVH_WORD_PLACE] == 0 ? "" : place + "has a free word that is not 0";
}

std::string TriangleTally::first_left_over() const {
  for (std::size_t i = 0; i < by_id_.size(); ++i) {
    const BvhTriangle& triangle = triangles_[by_id_[i]];
    if (i > 0 && triangles_[by_id_[i - 1]].id == triangle.id) {
      return "input: two triangles have id " + std::to_string(triangle.id);
    }
    if (!seen_[by_id_[i]] && !has_no_area(triangle)) {
      return "triangle " + std::to_string(triangle.id) + " is missing";
    }
  }
  return "";
}

}  // namespace vernier
