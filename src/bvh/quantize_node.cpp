#include "bvh/quantize_node.h"

#include <algorithm>
#include <array>
#include <bit>

#include "shared/bvh_record.h"

namespace vernier {
namespace {

constexpr int kLargestByte = 255;
constexpr int kFloatMantissaBits = 23;
constexpr int kTwiceFloatBias = 254;

// Distances along the axes with the errors of their rounding: origin + rounded + error is exactly the coordinate.
struct Distances {
  Lanes rounded, error;
};

// TwoSum (Knuth, The Art of Computer Programming 2, 4.2.2), exact in floats too.
Distances distances_from(Lanes origin, Lanes coordinate) {
  const Lanes rounded = coordinate - origin;
  const Lanes virtual_origin = coordinate - rounded;
  return {rounded, (coordinate - (rounded + virtual_origin)) + (virtual_origin - origin)};
}

// Cells of 2^(byte - 127) along each axis. Whole numbers of cells up to 2^24, and distances in cells that are not below
// 2^-126, are floats.
struct CellGrid {
  Lanes cell, cells_per_unit;

  explicit CellGrid(IntLanes byte)
      : cell(std::bit_cast<Lanes>(byte << kFloatMantissaBits)),
        cells_per_unit(std::bit_cast<Lanes>((kTwiceFloatBias - byte) << kFloatMantissaBits)) {}

  // The rounded distance may have landed on a whole number of cells from either side, but cannot have passed one.
  // Comparisons are true as -1.
  IntLanes down(const Distances& distance) const {
    const IntLanes whole = whole_cells(distance);
    return whole + ((length(whole) == distance.rounded) & (distance.error < 0.0f));
  }
  IntLanes up(const Distances& distance) const {
    const IntLanes whole = whole_cells(distance);
    const Lanes reached = length(whole);
    return whole - ((reached < distance.rounded) | ((reached == distance.rounded) & (distance.error > 0.0f)));
  }

 private:
  IntLanes whole_cells(const Distances& distance) const {
    return __builtin_convertvector(distance.rounded * cells_per_unit, IntLanes);
  }
  Lanes length(IntLanes whole) const { return __builtin_convertvector(whole, Lanes) * cell; }
};

// The least exponent bytes with which 255 cells reach as far as `distance`: those of a 255th of it or, where that is no
// power of two, the next.
IntLanes exponent_bytes(const Distances& distance) {
  const IntLanes exponent = std::bit_cast<IntLanes>(distance.rounded / kLargestByte) >> kFloatMantissaBits;
  const IntLanes lowest = IntLanes{} + static_cast<int>(kLeastExponent);
  const IntLanes byte = exponent > lowest ? exponent : lowest;
  return byte - (CellGrid(byte).up(distance) > kLargestByte);
}

// A grid whose origin lies a cell or more below a box that ends within 255 cells of it.
struct PlacedGrid {
  Lanes origin;
  IntLanes exponents;
};

PlacedGrid place_grid(const LaneBox& node) {
  PlacedGrid placed{{}, exponent_bytes(distances_from(node.lo, node.hi))};
  for (;;) {
    const CellGrid grid(placed.exponents);
    placed.origin = node.lo - grid.cell;
    // The difference may have been rounded up: then to the next float below.
    const IntLanes bits = std::bit_cast<IntLanes>(placed.origin);
    const IntLanes below = bits < 0 ? bits + 1 : bits - 1;
    placed.origin = std::bit_cast<Lanes>(grid.down(distances_from(placed.origin, node.lo)) < 1 ? below : bits);
    const IntLanes beyond = grid.up(distances_from(placed.origin, node.hi)) > kLargestByte;
    if ((beyond[0] | beyond[1] | beyond[2]) == 0) return placed;
    placed.exponents -= beyond;
  }
}

}  // namespace

BvhRecord quantize_node(std::span<const LaneBox> children, const LaneBox& node, std::uint32_t child_base) {
  using Words = std::uint32_t __attribute__((vector_size(16)));
  const auto [origin, exponents] = place_grid(node);
  const CellGrid grid(exponents);
  // A byte for each child, in a word for each axis.
  Words lo = {};
  Words hi = {};
  std::uint32_t empty_slots = 0xffffffffu;
  for (std::size_t i = 0; i < children.size(); ++i) {
    const auto shift = static_cast<std::uint32_t>(8 * i);
    lo |= std::bit_cast<Words>(grid.down(distances_from(origin, children[i].lo))) << shift;
    hi |= std::bit_cast<Words>(grid.up(distances_from(origin, children[i].hi))) << shift;
    empty_slots &= ~(0xffu << shift);
  }
  lo |= empty_slots;
  hi |= empty_slots & 0x01010101u;
  return {std::bit_cast<std::uint32_t>(origin[0]),
          std::bit_cast<std::uint32_t>(origin[1]),
          std::bit_cast<std::uint32_t>(origin[2]),
          static_cast<std::uint32_t>(exponents[0] | exponents[1] << 8 | exponents[2] << 16),
          lo[0],
          hi[0],
          lo[1],
          hi[1],
          lo[2],
          hi[2],
          BVH_CHILD_BASE_TAG | child_base,
          static_cast<std::uint32_t>(children.size())};
}

BvhRecord quantize_node(std::span<const Box> children, const Box& node, std::uint32_t child_base) {
  std::array<LaneBox, 4> boxes;
  std::ranges::transform(children, boxes.begin(), [](const Box& box) { return lane_box(box); });
  return quantize_node(std::span<const LaneBox>(boxes).first(children.size()), lane_box(node), child_base);
}

}  // namespace vernier
