#include "effects/texture_values.h"

#include <algorithm>
#include <bit>

namespace vernier {
namespace {

bool any(const std::array<bool, 4>& channels) {
  return std::ranges::find(channels, true) != channels.end();
}

TextureValues values_of(const Texels& texels) {
  const bool is_float = texels.format == TEXTURE_FORMAT_FLOAT;
  const std::size_t count = is_float ? texels.words.size() / 4 : texels.words.size();
  if (count == 0) return {};
  TextureValues values{{true, true, true, true}, {true, true, true, true}};
  for (std::size_t texel = 0; texel < count && (any(values.zero) || any(values.one)); ++texel) {
    for (std::size_t channel = 0; channel < 4; ++channel) {
      // Both encodings of bytes take 0 to 0 and 255 to 1.
      const float value = is_float ? std::bit_cast<float>(texels.words[4 * texel + channel])
                                   : static_cast<float>((texels.words[texel] >> (8 * channel)) & 255u) / 255.0f;
      values.zero[channel] = values.zero[channel] && value == 0.0f;
      values.one[channel] = values.one[channel] && value == 1.0f;
    }
  }
  return values;
}

}  // namespace

std::vector<TextureValues> texture_values(const Scene& scene, const std::vector<bool>& wanted) {
  std::vector<TextureValues> values(scene.textures.size());
  for (std::size_t index = 0; index < values.size(); ++index) {
    const Texels* texels = scene.textures[index].texels.get();
    if (wanted[index] && texels != nullptr) values[index] = values_of(*texels);
  }
  return values;
}

}  // namespace vernier
