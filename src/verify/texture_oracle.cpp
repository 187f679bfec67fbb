#include "verify/texture_oracle.h"

#include <algorithm>
#include <cmath>

#include "shared/material_flags.h"

namespace vernier {
namespace {

/// The texel that stands in for texel `i`, -1 to `size`.
long neighbour(long i, long size, std::uint32_t wrap) {
  return wrap == TEXTURE_WRAP_REPEAT ? (i + size) % size : std::clamp(i, 0L, size - 1);
}

}  // namespace

long double wrapped_place(long double x, std::uint32_t wrap) {
  if (wrap == TEXTURE_WRAP_CLAMP) return std::clamp(x, 0.0L, 1.0L);
  if (wrap == TEXTURE_WRAP_MIRROR) return 1.0L - std::abs(1.0L - (x - 2.0L * std::floor(x / 2.0L)));
  return x - std::floor(x);
}

long texel_of(long double place, long size) {
  return std::clamp(static_cast<long>(std::floor(place * static_cast<long double>(size))), 0L, size - 1);
}

LinearRead exact_linear(long double x, long size, std::uint32_t wrap) {
  const long double place = wrapped_place(x, wrap) * static_cast<long double>(size) - 0.5L;
  const long left = static_cast<long>(std::floor(place));
  const auto from = static_cast<long double>(neighbour(left, size, wrap));
  const auto to = static_cast<long double>(neighbour(left + 1, size, wrap));
  // The seam of a repeated row, which lies next to its first and last cell, is the steepest place.
  const bool at_seam = wrap == TEXTURE_WRAP_REPEAT && (left <= 0 || left >= size - 2);
  return {from + (to - from) * (place - static_cast<long double>(left)),
          at_seam ? std::max(static_cast<long double>(size - 1), 1.0L) : 1.0L};
}

}  // namespace vernier
