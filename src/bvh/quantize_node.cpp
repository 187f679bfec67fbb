#include "bvh/quantize_node.h"

#include <algorithm>
#include <array>
#include <bit>

namespace vernier {
namespace {

constexpr int kLargestByte = 255;
constexpr int kFloatExponentBias = 127;
constexpr std::uint64_t kDoubleExponentBias = 1023;
constexpr int kDoubleMantissaBits = 52;

// 2^exponent.
double power_of_two(int exponent) {
  return std::bit_cast<double>((kDoubleExponentBias + static_cast<std::uint64_t>(exponent)) << kDoubleMantissaBits);
}

// A distance along an axis with the error of its rounding: origin + distance + error is exactly the coordinate.
struct Distance {
  double rounded, error;
};

// TwoSum (Knuth, The Art of Computer Programming 2, 4.2.2): float coordinates of very different size differ by more
// than 53 bits.
Distance distance_from(double origin, double coordinate) {
  const double rounded = coordinate - origin;
  const double virtual_origin = coordinate - rounded;
  return {rounded, (coordinate - (rounded + virtual_origin)) + (virtual_origin - origin)};
}

// The rounded distance may have landed on a whole number of cells from either side, but cannot have passed one.
int cells_down(const Distance& distance, double cells_per_unit) {
  const double cells = distance.rounded * cells_per_unit;
  const int whole = static_cast<int>(cells);
  return whole == cells && distance.error < 0.0 ? std::max(whole - 1, 0) : whole;
}

int cells_up(const Distance& distance, double cells_per_unit) {
  const double cells = distance.rounded * cells_per_unit;
  const int whole = static_cast<int>(cells);
  return whole < cells || (whole == cells && distance.error > 0.0) ? whole + 1 : whole;
}

// The least exponent byte with which 255 cells reach as far as `distance`.
std::uint32_t exponent_byte(const Distance& distance) {
  const double least_cell = distance.rounded / kLargestByte;
  const auto bits = std::bit_cast<std::uint64_t>(least_cell);
  const int exponent = static_cast<int>(bits >> kDoubleMantissaBits) - static_cast<int>(kDoubleExponentBias);
  const auto lowest = static_cast<int>(kLeastExponent) - kFloatExponentBias;
  int cell = std::max(exponent, lowest);
  while (cells_up(distance, power_of_two(-cell)) > kLargestByte) {
    ++cell;
  }
  return static_cast<std::uint32_t>(cell + kFloatExponentBias);
}

struct AxisBytes {
  std::uint32_t exponent, lo, hi;
};

AxisBytes quantize_axis(std::span<const Box> children, const Box& node, int axis) {
  const double origin = node.lo[axis];
  AxisBytes bytes{exponent_byte(distance_from(origin, node.hi[axis])), 0xffffffffu, 0u};
  const double cells_per_unit = power_of_two(kFloatExponentBias - static_cast<int>(bytes.exponent));
  for (std::size_t i = 0; i < children.size(); ++i) {
    const int lo = cells_down(distance_from(origin, children[i].lo[axis]), cells_per_unit);
    const int hi = cells_up(distance_from(origin, children[i].hi[axis]), cells_per_unit);
    const auto shift = static_cast<std::uint32_t>(8 * i);
    bytes.lo = (bytes.lo & ~(0xffu << shift)) | static_cast<std::uint32_t>(lo) << shift;
    bytes.hi |= static_cast<std::uint32_t>(hi) << shift;
  }
  return bytes;
}

}  // namespace

BvhRecord quantize_node(std::span<const Box> children, const Box& node, std::uint32_t child_base) {
  const AxisBytes x = quantize_axis(children, node, 0);
  const AxisBytes y = quantize_axis(children, node, 1);
  const AxisBytes z = quantize_axis(children, node, 2);
  return {std::bit_cast<std::uint32_t>(node.lo.x),
          std::bit_cast<std::uint32_t>(node.lo.y),
          std::bit_cast<std::uint32_t>(node.lo.z),
          x.exponent | y.exponent << 8 | z.exponent << 16,
          x.lo,
          x.hi,
          y.lo,
          y.hi,
          z.lo,
          z.hi,
          child_base,
          static_cast<std::uint32_t>(children.size())};
}

}  // namespace vernier
