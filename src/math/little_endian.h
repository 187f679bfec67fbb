#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace vernier {

/// The number that `bytes` of `data` (1 to 4) from `offset` on are, the lowest first. They lie within `data`.
inline std::uint32_t little_endian(std::span<const std::byte> data, std::size_t offset, std::size_t bytes = 4) {
  std::uint32_t value = 0;
  for (std::size_t i = bytes; i-- > 0;) value = value << 8 | std::to_integer<std::uint32_t>(data[offset + i]);
  return value;
}

}  // namespace vernier
