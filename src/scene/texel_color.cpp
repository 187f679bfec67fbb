#include "scene/texel_color.h"

#include <bit>

#include "image/srgb_curve.h"

namespace vernier {

glm::vec4 texel_color(const Texels& texels, std::size_t index) {
  if (texels.format == TEXTURE_FORMAT_FLOAT) {
    const std::uint32_t* words = texels.words.data() + 4 * index;
    return {std::bit_cast<float>(words[0]), std::bit_cast<float>(words[1]), std::bit_cast<float>(words[2]),
            std::bit_cast<float>(words[3])};
  }
  const std::uint32_t word = texels.words[index];
  const auto channel = [&](unsigned shift) { return float((word >> shift) & 255u) / 255.0f; };
  const glm::vec4 stored(channel(0), channel(8), channel(16), channel(24));
  if (texels.format == TEXTURE_FORMAT_LINEAR8) return stored;
  return {float(linear_from_srgb(stored.r)), float(linear_from_srgb(stored.g)), float(linear_from_srgb(stored.b)),
          stored.a};
}

}  // namespace vernier
