#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <span>

namespace vernier {

/// Width and height of a WebP image that does not move; none for anything else. OpenImageIO 2.4 multiplies the colours
/// of such images by their alpha, whatever it is asked for.
std::optional<glm::ivec2> still_webp_size(std::span<const std::byte> encoded);

/// Decodes one to `texels`, [height][width] words of r g b a from the lowest byte, as many as still_webp_size says.
/// False where it is broken or cut off.
bool decode_still_webp(std::span<const std::byte> encoded, glm::ivec2 size, std::span<std::uint32_t> texels);

}  // namespace vernier
