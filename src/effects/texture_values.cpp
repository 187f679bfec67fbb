#include "effects/texture_values.h"

#include <algorithm>
#include <bit>
#include <map>
#include <span>

namespace vernier {
namespace {

bool any(const std::array<bool, 4>& channels) {
  return std::ranges::find(channels, true) != channels.end();
}

std::uint32_t channel_of(std::uint32_t word, std::size_t channel) {
  return word >> (8 * channel) & 255u;
}

// Both encodings of bytes take 0 to 0 and 255 to 1.
TextureValues values_of_bytes(std::span<const std::uint32_t> words) {
  constexpr std::size_t kBlock = 4096;  // long enough for vector instructions, short enough to stop soon
  std::uint32_t in_all = ~0u;
  std::uint32_t in_any = 0;
  TextureValues values{{true, true, true, true}, {true, true, true, true}};
  for (std::size_t begin = 0; begin < words.size() && (any(values.zero) || any(values.one)); begin += kBlock) {
    for (const std::uint32_t word : words.subspan(begin, std::min(kBlock, words.size() - begin))) {
      in_all &= word;
      in_any |= word;
    }
    for (std::size_t channel = 0; channel < 4; ++channel) {
      values.zero[channel] = channel_of(in_any, channel) == 0;
      values.one[channel] = channel_of(in_all, channel) == 255;
    }
  }
  return values;
}

TextureValues values_of_floats(std::span<const std::uint32_t> words) {
  TextureValues values{{true, true, true, true}, {true, true, true, true}};
  for (std::size_t word = 0; word < words.size() && (any(values.zero) || any(values.one)); ++word) {
    const float value = std::bit_cast<float>(words[word]);
    values.zero[word % 4] = values.zero[word % 4] && value == 0.0f;
    values.one[word % 4] = values.one[word % 4] && value == 1.0f;
  }
  return values;
}

TextureValues values_of(const Texels& texels) {
  if (texels.words.empty()) return {};
  return texels.format == TEXTURE_FORMAT_FLOAT ? values_of_floats(texels.words) : values_of_bytes(texels.words);
}

}  // namespace

std::vector<TextureValues> texture_values(const Scene& scene, const std::vector<bool>& wanted) {
  std::vector<TextureValues> values(scene.textures.size());
  std::map<const Texels*, TextureValues> known;  // textures may share texels
  for (std::size_t index = 0; index < values.size(); ++index) {
    const Texels* texels = scene.textures[index].texels.get();
    if (!wanted[index] || texels == nullptr) continue;
    const auto [entry, is_new] = known.try_emplace(texels);
    if (is_new) entry->second = values_of(*texels);
    values[index] = entry->second;
  }
  return values;
}

}  // namespace vernier
