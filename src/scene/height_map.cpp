#include "scene/height_map.h"

#include <bit>

#include "scene/texel_color.h"

namespace vernier {
namespace {

std::size_t texel_count(const Texels& texels) {
  return std::size_t{texels.width} * texels.height;
}

bool has_transparency(const Texels& texels) {
  for (std::size_t i = 0; i < texel_count(texels); ++i) {
    if (texel_color(texels, i).a < 1.0f) return true;
  }
  return false;
}

float channel_value(const glm::vec4& color, char channel) {
  switch (channel) {
    case 'r':
      return color.r;
    case 'g':
      return color.g;
    case 'b':
      return color.b;
    case 'm':
    case 'z':
      return color.a;
    default:
      // Grey images have three equal channels: their value must survive exactly.
      return color.r == color.g && color.g == color.b ? color.r : (color.r + color.g + color.b) / 3.0f;
  }
}

std::uint32_t neighbour(std::uint32_t i, int step, std::uint32_t count, std::uint32_t wrap) {
  const std::int64_t moved = std::int64_t{i} + step;
  if (moved >= 0 && moved < count) return static_cast<std::uint32_t>(moved);
  return wrap == TEXTURE_WRAP_REPEAT ? static_cast<std::uint32_t>((moved + count) % count) : i;
}

}  // namespace

Texels scalar_map(const Texels& texels, char channel) {
  Texels result = texels;
  // The values as stored: an 8-bit image is read without the sRGB curve.
  if (result.format == TEXTURE_FORMAT_SRGB8) result.format = TEXTURE_FORMAT_LINEAR8;
  if (channel == '\0') channel = has_transparency(result) ? 'm' : 'l';
  const bool is_float = result.format == TEXTURE_FORMAT_FLOAT;
  for (std::size_t i = 0; i < texel_count(result); ++i) {
    const float value = channel_value(texel_color(result, i), channel);
    if (is_float) {
      for (std::size_t c = 0; c < 3; ++c) result.words[4 * i + c] = std::bit_cast<std::uint32_t>(value);
      result.words[4 * i + 3] = std::bit_cast<std::uint32_t>(1.0f);
    } else {
      const auto byte = static_cast<std::uint32_t>(value * 255.0f + 0.5f);
      result.words[i] = byte | byte << 8 | byte << 16 | 0xff000000u;
    }
  }
  return result;
}

Texels normals_from_heights(const Texels& heights, double strength, std::uint32_t wrap) {
  Texels normals{TEXTURE_FORMAT_FLOAT, heights.width, heights.height, {}};
  normals.words.reserve(4 * texel_count(heights));
  const auto height = [&](std::uint32_t x, std::uint32_t y) {
    return double{texel_color(heights, std::size_t{y} * heights.width + x).r};
  };
  for (std::uint32_t y = 0; y < heights.height; ++y) {
    const std::uint32_t above = neighbour(y, -1, heights.height, wrap);
    const std::uint32_t below = neighbour(y, 1, heights.height, wrap);
    for (std::uint32_t x = 0; x < heights.width; ++x) {
      const std::uint32_t left = neighbour(x, -1, heights.width, wrap);
      const std::uint32_t right = neighbour(x, 1, heights.width, wrap);
      const glm::dvec2 slope(height(right, y) - height(left, y), height(x, above) - height(x, below));
      const glm::dvec3 normal = glm::normalize(glm::dvec3(-0.5 * strength * slope, 1.0));
      for (int c = 0; c < 3; ++c) {
        normals.words.push_back(std::bit_cast<std::uint32_t>(static_cast<float>(0.5 * normal[c] + 0.5)));
      }
      normals.words.push_back(std::bit_cast<std::uint32_t>(1.0f));
    }
  }
  return normals;
}

}  // namespace vernier
