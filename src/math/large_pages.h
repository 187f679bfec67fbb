#pragma once

#include <cstddef>
#include <span>

namespace vernier {

/// Bytes of a large page on x86-64 and on most ARM systems; elsewhere only an alignment.
inline constexpr std::size_t kLargePageBytes = std::size_t{1} << 21;

/// Asks the system to back what whole large pages lie in `memory` by such, before they are touched. A wish: where it is
/// not granted, or not known, small pages do.
void wish_for_large_pages(std::span<std::byte> memory);

}  // namespace vernier
