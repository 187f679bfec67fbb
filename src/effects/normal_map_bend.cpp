#include "effects/normal_map_bend.h"

#include <bit>
#include <cmath>

namespace vernier {
namespace {

glm::vec3 decoded(const Texels& texels, std::size_t texel) {
  if (texels.format == TEXTURE_FORMAT_FLOAT) {
    const std::uint32_t* words = texels.words.data() + 4 * texel;
    return {std::bit_cast<float>(words[0]), std::bit_cast<float>(words[1]), std::bit_cast<float>(words[2])};
  }
  const std::uint32_t word = texels.words[texel];
  return glm::vec3(word & 255u, word >> 8 & 255u, word >> 16 & 255u) / 255.0f;
}

// The slope is (2 x - 1, 2 y - 1) times `scale`, and between texels of 1/2 every look-up is 1/2. The height, 2 z - 1,
// must stay above 0 whatever rounding does between texels, which is less than 2^-20.
bool is_flat(const glm::vec3& texel, float scale) {
  const bool level = scale == 0.0f ? std::isfinite(texel.x) && std::isfinite(texel.y)
                                   : std::isfinite(scale) && texel.x == 0.5f && texel.y == 0.5f;
  return level && texel.z >= 0.5f + 0x1p-20f && std::isfinite(texel.z);
}

}  // namespace

NormalMapBend normal_map_bend(const Texels& texels, float scale) {
  // The curve of sRGB bytes takes none to 1/2 either.
  if (texels.format == TEXTURE_FORMAT_SRGB8 || texels.words.empty()) return NormalMapBend::varies;
  const std::size_t count = texels.words.size() / (texels.format == TEXTURE_FORMAT_FLOAT ? 4 : 1);
  const glm::vec3 first = decoded(texels, 0);
  bool flat = true;
  bool alike = true;
  for (std::size_t texel = 0; texel < count && (flat || alike); ++texel) {
    const glm::vec3 value = decoded(texels, texel);
    flat = flat && is_flat(value, scale);
    alike = alike && value == first;
  }
  if (flat) return NormalMapBend::none;
  return alike ? NormalMapBend::alike : NormalMapBend::varies;
}

}  // namespace vernier
