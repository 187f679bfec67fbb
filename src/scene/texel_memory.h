#pragma once

#include <cstdint>
#include <string>

#include "math/memory_claim.h"

namespace vernier {

/// Claims what the image `name` needs to be read or decoded (MemoryClaim::take). Throws MemoryError where it is not
/// there.
void claim_texel_memory(MemoryClaim& claim, const std::string& name, std::uint64_t bytes);

/// Throws MemoryError where the image `name` needs so many bytes, and fewer are `there`.
void check_texel_memory(const std::string& name, std::uint64_t bytes, std::uint64_t there);

}  // namespace vernier
