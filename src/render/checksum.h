#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace vernier {

/// Checksum of nothing: where checksum begins.
inline constexpr std::uint64_t kEmptyChecksum = 0xcbf29ce484222325u;

/// FNV-1a of 64 bits (Fowler, Noll, Vo) of `bytes`, going on from `before`. Any change of one byte changes it: finds
/// damage, not forgery.
std::uint64_t checksum(std::span<const std::byte> bytes, std::uint64_t before = kEmptyChecksum);

}  // namespace vernier
