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
  // A little less than 2^21, so that the roundings of scale and product leave the largest centre in the last cell.
  constexpr float kCells = 0x1p21f * (1.0f - 0x1p-22f);
  // 2^21 divided by a side below the first would overflow: such sides are made longer first, by the second.
  constexpr float kShort = 0x1p-60f, kStretch = 0x1p90f;
  const Lanes side = centres.hi - centres.lo;
  const float longest = std::max({side[0], side[1], side[2]});
  stretch_ = longest < kShort ? kStretch : 1.0f;
  scale_ = longest > 0.0f ? kCells / (longest * stretch_) : 0.0f;
}

std::uint64_t MortonGrid::code(Lanes centre) const {
  const IntLanes cell = __builtin_convertvector((without_lane_3(centre) - origin_) * stretch_ * scale_, IntLanes);
  const auto bits = [&](int axis) { return spread_bits(static_cast<std::uint32_t>(cell[axis])); };
  return bits(0) << 2 | bits(1) << 1 | bits(2);
}

}  // namespace vernier
