#include "bvh/hidden_triangles.h"

#include <bit>
#include <cstring>

#include "bvh/zero_area.h"

namespace vernier {
namespace {

constexpr std::size_t kCornerBytes = 9 * sizeof(float);

bool same_corners(const BvhTriangle& a, const BvhTriangle& b) {
  return std::memcmp(&a, &b, kCornerBytes) == 0;
}

/// Mixes the bits of all corners (the multiplier is that of Knuth's 64-bit linear congruential generator, MMIX).
std::uint64_t hash_of(const BvhTriangle& triangle) {
  std::uint32_t words[9];
  std::memcpy(words, &triangle, kCornerBytes);
  std::uint64_t hash = 0;
  for (const std::uint32_t word : words) hash = (std::rotl(hash, 29) ^ word) * 6364136223846793005u;
  return hash ^ (hash >> 32);
}

}  // namespace

std::vector<BvhTriangle> without_hidden(std::span<const BvhTriangle> triangles,
                                        const std::function<bool(std::uint32_t)>& not_opaque) {
  constexpr std::uint32_t kEmpty = 0xffffffffu;
  // Open addressing, at most half full: index in `kept` of the opaque triangles.
  const std::size_t mask = std::bit_ceil(2 * triangles.size() + 1) - 1;
  std::vector<std::uint32_t> table(mask + 1, kEmpty);
  std::vector<BvhTriangle> kept;
  kept.reserve(triangles.size());
  for (const BvhTriangle& triangle : triangles) {
    std::size_t slot = hash_of(triangle) & mask;
    while (table[slot] != kEmpty && !same_corners(kept[table[slot]], triangle)) slot = (slot + 1) & mask;
    const bool is_first = table[slot] == kEmpty;
    if (!is_first && !has_zero_area(triangle.v0, triangle.v1, triangle.v2)) continue;
    if (is_first && (!not_opaque || !not_opaque(triangle.id))) table[slot] = static_cast<std::uint32_t>(kept.size());
    kept.push_back(triangle);
  }
  return kept;
}

}  // namespace vernier
