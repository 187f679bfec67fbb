#include "bvh/bin_split.h"

#include <algorithm>
#include <array>
#include <limits>
#include <mutex>

namespace vernier {
namespace {

constexpr int kBinCount = 16;
// Below this many references threads cost more than they save.
constexpr std::size_t kThreadedCount = 1u << 14;

struct Bins {
  std::array<std::array<LaneBox, kBinCount>, 3> boxes;
  std::array<std::array<std::uint32_t, kBinCount>, 3> counts{};
};

// Bin of a doubled centre c on each axis: (c - origin) * scale, rounded down. Scale 0 puts all into bin 0.
struct BinGrid {
  Lanes origin = {};
  Lanes scale = {};

  IntLanes bin(Lanes centre) const { return __builtin_convertvector((centre - origin) * scale, IntLanes); }
};

BinGrid make_grid(const LaneBox& centres) {
  // A little less than 16, so that the rounding of the largest centre's product stays in the last bin.
  constexpr float kBins = kBinCount * (1.0f - 0x1p-20f);
  // Below this the scale would overflow.
  constexpr float kLeastSide = 1e-36f;
  BinGrid grid{without_lane_3(centres.lo), {}};
  for (int axis = 0; axis < 3; ++axis) {
    const float side = centres.hi[axis] - centres.lo[axis];
    grid.scale[axis] = side > kLeastSide ? kBins / side : 0.0f;
  }
  return grid;
}

void fill_bins(std::span<const TriangleReference> references, const BinGrid& grid, Bins& bins) {
  for (const TriangleReference& reference : references) {
    const IntLanes bin = grid.bin(doubled_centre(reference));
    for (int axis = 0; axis < 3; ++axis) {
      bins.boxes[axis][bin[axis]].grow(reference.lo, reference.hi);
      ++bins.counts[axis][bin[axis]];
    }
  }
}

void merge_bins(const Bins& from, Bins& into) {
  for (int axis = 0; axis < 3; ++axis) {
    for (int i = 0; i < kBinCount; ++i) {
      into.boxes[axis][i].grow(from.boxes[axis][i]);
      into.counts[axis][i] += from.counts[axis][i];
    }
  }
}

// Minima, maxima and counts do not depend on the order in which the pieces are merged.
void fill_bins_threaded(std::span<const TriangleReference> references, const BinGrid& grid, ThreadTeam& team,
                        Bins& bins) {
  std::mutex merge_mutex;
  const std::size_t piece = references.size() / team.thread_count() + 1;
  team.run((references.size() + piece - 1) / piece, [&](std::size_t i) {
    Bins own;
    fill_bins(references.subspan(i * piece, std::min(piece, references.size() - i * piece)), grid, own);
    const std::scoped_lock lock(merge_mutex);
    merge_bins(own, bins);
  });
}

// The last bin of the left side and what the split costs: sum of half area x number of triangles.
struct BinChoice {
  float cost = std::numeric_limits<float>::infinity();
  int axis = -1;
  int last_left_bin = 0;
};

void consider_axis(const Bins& bins, int axis, float area_scale, BinChoice& best) {
  const auto& boxes = bins.boxes[axis];
  const auto& counts = bins.counts[axis];
  std::array<float, kBinCount> right_costs;
  LaneBox right;
  std::uint32_t right_count = 0;
  for (int i = kBinCount - 1; i > 0; --i) {
    right.grow(boxes[i]);
    right_count += counts[i];
    right_costs[i] = scaled_half_area(right, area_scale) * static_cast<float>(right_count);
  }
  LaneBox left;
  std::uint32_t left_count = 0;
  const std::uint32_t all = right_count + counts[0];
  for (int i = 0; i + 1 < kBinCount; ++i) {
    left.grow(boxes[i]);
    left_count += counts[i];
    // The area of an empty side means nothing.
    if (left_count == 0 || left_count == all) {
      continue;
    }
    const float cost = scaled_half_area(left, area_scale) * static_cast<float>(left_count) + right_costs[i + 1];
    if (cost < best.cost) {
      best = {cost, axis, i};
    }
  }
}

// Puts the left side first, from both ends inwards, and gathers the bounds of the centres.
std::size_t partition(std::span<TriangleReference> references, const BinGrid& grid, const BinChoice& choice,
                      Split& split) {
  std::size_t begin = 0;
  std::size_t end = references.size();
  while (begin < end) {
    const TriangleReference reference = references[begin];
    const Lanes centre = doubled_centre(reference);
    if (grid.bin(centre)[choice.axis] <= choice.last_left_bin) {
      split.left.centres.grow(centre, centre);
      ++begin;
    } else {
      split.right.centres.grow(centre, centre);
      references[begin] = references[--end];
      references[end] = reference;
    }
  }
  return begin;
}

}  // namespace

std::optional<Split> split_by_bins(std::span<TriangleReference> references, const ReferenceBounds& bounds,
                                   float area_scale, ThreadTeam* team) {
  const BinGrid grid = make_grid(bounds.centres);
  Bins bins;
  if (team != nullptr && team->thread_count() > 1 && references.size() > kThreadedCount) {
    fill_bins_threaded(references, grid, *team, bins);
  } else {
    fill_bins(references, grid, bins);
  }
  BinChoice choice;
  for (int axis = 0; axis < 3; ++axis) {
    if (grid.scale[axis] > 0.0f) {
      consider_axis(bins, axis, area_scale, choice);
    }
  }
  if (choice.axis < 0) {
    return std::nullopt;
  }
  Split split;
  for (int i = 0; i < kBinCount; ++i) {
    (i <= choice.last_left_bin ? split.left : split.right).box.grow(bins.boxes[choice.axis][i]);
  }
  split.middle = partition(references, grid, choice, split);
  return split;
}

}  // namespace vernier
