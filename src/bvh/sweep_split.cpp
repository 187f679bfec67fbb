#include "bvh/sweep_split.h"

#include <algorithm>
#include <array>
#include <limits>

namespace vernier {
namespace {

using Order = std::array<std::uint8_t, kSweepLimit>;
using Centres = std::array<Lanes, kSweepLimit>;

struct SweepChoice {
  float cost = std::numeric_limits<float>::infinity();
  Order order{};
  std::size_t middle = 1;
};

// Insertion sort: stable, and the quickest there is for so few.
Order order_by_centre(const Centres& centres, std::size_t count, int axis) {
  Order order{};
  for (std::size_t i = 0; i < count; ++i) {
    const float key = centres[i][axis];
    std::size_t place = i;
    for (; place > 0 && centres[order[place - 1]][axis] > key; --place) {
      order[place] = order[place - 1];
    }
    order[place] = static_cast<std::uint8_t>(i);
  }
  return order;
}

void consider_order(std::span<const TriangleReference> references, const Order& order, float area_scale,
                    SweepChoice& best) {
  const std::size_t count = references.size();
  std::array<float, kSweepLimit> right_costs{};
  LaneBox right;
  for (std::size_t i = count - 1; i > 0; --i) {
    right.grow(references[order[i]].lo, references[order[i]].hi);
    right_costs[i] = scaled_half_area(right, area_scale) * static_cast<float>(count - i);
  }
  LaneBox left;
  for (std::size_t i = 1; i < count; ++i) {
    left.grow(references[order[i - 1]].lo, references[order[i - 1]].hi);
    const float cost = scaled_half_area(left, area_scale) * static_cast<float>(i) + right_costs[i];
    if (cost < best.cost) {
      best.cost = cost;
      best.order = order;
      best.middle = i;
    }
  }
}

}  // namespace

Split split_by_sweep(std::span<TriangleReference> references, float area_scale) {
  SweepChoice best;
  for (std::size_t i = 0; i < references.size(); ++i) {
    best.order[i] = static_cast<std::uint8_t>(i);
  }
  if (references.size() > 2) {
    Centres centres;
    for (std::size_t i = 0; i < references.size(); ++i) {
      centres[i] = doubled_centre(references[i]);
    }
    for (int axis = 0; axis < 3; ++axis) {
      consider_order(references, order_by_centre(centres, references.size(), axis), area_scale, best);
    }
  }
  std::array<TriangleReference, kSweepLimit> unordered;
  std::copy(references.begin(), references.end(), unordered.begin());
  Split split;
  split.middle = best.middle;
  for (std::size_t i = 0; i < references.size(); ++i) {
    references[i] = unordered[best.order[i]];
    (i < split.middle ? split.left : split.right).grow(references[i]);
  }
  return split;
}

}  // namespace vernier
