#include "bvh/sorted_split.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace vernier {
namespace {

struct SplitChoice {
  float cost = std::numeric_limits<float>::infinity();
  int axis = 0;
  std::size_t middle = 1;
};

void sort_by_centre(std::span<TriangleReference> references, int axis) {
  std::ranges::sort(references, [axis](const TriangleReference& a, const TriangleReference& b) {
    const float centre_a = doubled_centre(a)[axis], centre_b = doubled_centre(b)[axis];
    return centre_a != centre_b ? centre_a < centre_b : triangle_index(a) < triangle_index(b);
  });
}

void consider_order(std::span<const TriangleReference> sorted, int axis, float area_scale,
                    std::vector<float>& right_costs, SplitChoice& best) {
  const std::size_t count = sorted.size();
  LaneBox right;
  for (std::size_t i = count - 1; i > 0; --i) {
    right.grow(sorted[i].lo, sorted[i].hi);
    right_costs[i] = scaled_half_area(right, area_scale) * static_cast<float>(count - i);
  }
  LaneBox left;
  for (std::size_t i = 1; i < count; ++i) {
    left.grow(sorted[i - 1].lo, sorted[i - 1].hi);
    const float cost = scaled_half_area(left, area_scale) * static_cast<float>(i) + right_costs[i];
    if (cost < best.cost) best = {cost, axis, i};
  }
}

}  // namespace

Split split_by_sorting(std::span<TriangleReference> references, float area_scale) {
  std::vector<float> right_costs(references.size());
  SplitChoice best;
  for (int axis = 0; axis < 3; ++axis) {
    sort_by_centre(references, axis);
    consider_order(references, axis, area_scale, right_costs, best);
  }
  sort_by_centre(references, best.axis);
  return {best.middle, bounds_of(references.first(best.middle)), bounds_of(references.subspan(best.middle))};
}

}  // namespace vernier
