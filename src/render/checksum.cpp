#include "render/checksum.h"

namespace vernier {

std::uint64_t checksum(std::span<const std::byte> bytes, std::uint64_t before) {
  constexpr std::uint64_t kPrime = 0x100000001b3u;
  for (const std::byte byte : bytes) before = (before ^ std::to_integer<std::uint64_t>(byte)) * kPrime;
  return before;
}

}  // namespace vernier
