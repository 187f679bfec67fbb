#include "reference/textures.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace vernier::reference {

namespace {

// IEC 61966-2-1.
double linear_from_srgb(double value) {
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

std::array<double, 256> make_srgb_table() {
  std::array<double, 256> table;
  for (int byte = 0; byte < 256; ++byte) table[byte] = linear_from_srgb(byte / 255.0);
  return table;
}

double wrap(double x, std::uint32_t mode) {
  if (mode == TEXTURE_WRAP_CLAMP) return std::clamp(x, 0.0, 1.0);
  if (mode == TEXTURE_WRAP_MIRROR) return 1.0 - std::abs(1.0 - (x - 2.0 * std::floor(x / 2.0)));
  return x - std::floor(x);
}

// The neighbours of a wrapped coordinate reach at most one texel beyond the image.
int wrap_texel(int x, int size, std::uint32_t mode) {
  if (mode == TEXTURE_WRAP_REPEAT) return (x + size) % size;
  return std::clamp(x, 0, size - 1);
}

}  // namespace

glm::dvec4 texel(const Texels& texels, int x, int y) {
  const std::size_t index = static_cast<std::size_t>(y) * texels.width + x;
  if (texels.format == TEXTURE_FORMAT_FLOAT) {
    glm::dvec4 value;
    for (int channel = 0; channel < 4; ++channel)
      value[channel] = std::bit_cast<float>(texels.words[4 * index + channel]);
    return value;
  }
  static const std::array<double, 256> srgb_table = make_srgb_table();
  glm::dvec4 value;
  for (int channel = 0; channel < 4; ++channel) {
    const std::uint32_t byte = (texels.words[index] >> (8 * channel)) & 255u;
    value[channel] = texels.format == TEXTURE_FORMAT_SRGB8 && channel < 3 ? srgb_table[byte] : byte / 255.0;
  }
  return value;
}

glm::dvec4 sample_texels(const Texels& texels, const Sampler& sampler, glm::dvec2 uv) {
  if (!std::isfinite(uv.x) || !std::isfinite(uv.y)) return texel(texels, 0, 0);
  const int width = static_cast<int>(texels.width);
  const int height = static_cast<int>(texels.height);
  const double x = wrap(uv.x, sampler.wrap_u) * width;
  const double y = wrap(uv.y, sampler.wrap_v) * height;
  if (sampler.filter == TEXTURE_FILTER_NEAREST)
    return texel(texels, std::min(static_cast<int>(x), width - 1), std::min(static_cast<int>(y), height - 1));
  const double left = std::floor(x - 0.5);
  const double top = std::floor(y - 0.5);
  const int x0 = wrap_texel(static_cast<int>(left), width, sampler.wrap_u);
  const int x1 = wrap_texel(static_cast<int>(left) + 1, width, sampler.wrap_u);
  const int y0 = wrap_texel(static_cast<int>(top), height, sampler.wrap_v);
  const int y1 = wrap_texel(static_cast<int>(top) + 1, height, sampler.wrap_v);
  const double fx = x - 0.5 - left;
  const double fy = y - 0.5 - top;
  return glm::mix(glm::mix(texel(texels, x0, y0), texel(texels, x1, y0), fx),
                  glm::mix(texel(texels, x0, y1), texel(texels, x1, y1), fx), fy);
}

}  // namespace vernier::reference
