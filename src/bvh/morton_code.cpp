#include "bvh/morton_code.h"

#include <algorithm>

namespace vernier {
namespace {

// The lowest 21 bits of `value`, each followed by two zeros: halves moved apart until bits stand alone.
std::uint64_t spread_bits(std::uint64_t value) {
  value = (value | value << 32) & 0x001f00000000ffffu;
  value = (value | value << 16) & 0x001f0000ff0000ffu;
  value = (value | value << 8) & 0x100f00f00f00f00fu;
  value = (value | value << 4) & 0x10c30c30c30c30c3u;
  return (value | value << 2) & 0x1249249249249249u;
}

}  // namespace

MortonGrid::MortonGrid(const LaneBox& centres) : origin_(without_lane_3(centres.lo)) {
  // Below this the scale would overflow.
  constexpr float kLeastSide = 1e-36f;
  // A little less than 2^21, so that the rounding of the largest centre's product stays in the last cell.
  constexpr float kCells = 0x1p21f * (1.0f - 0x1p-22f);
  const Lanes side = centres.hi - centres.lo;
  scale_ = kCells / std::max({side[0], side[1], side[2], kLeastSide});
}

std::uint64_t MortonGrid::code(Lanes centre) const {
  const IntLanes cell = __builtin_convertvector((without_lane_3(centre) - origin_) * scale_, IntLanes);
  const auto bits = [&](int axis) { return spread_bits(static_cast<std::uint32_t>(cell[axis])); };
  return bits(0) << 2 | bits(1) << 1 | bits(2);
}

}  // namespace vernier
