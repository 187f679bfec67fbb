#pragma once

#include <cstdint>
#include <string>

namespace vernier {

/// Throws MemoryError where the image `name` needs so many bytes decoded, and fewer are `there`.
void check_texel_memory(const std::string& name, std::uint64_t bytes, std::uint64_t there);

}  // namespace vernier
