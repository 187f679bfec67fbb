#include "codecs/webp_image.h"

#include <webp/decode.h>

#include <bit>

namespace vernier {
namespace {

static_assert(std::endian::native == std::endian::little, "libwebp writes bytes, texels are words");

const std::uint8_t* bytes_of(std::span<const std::byte> encoded) {
  return reinterpret_cast<const std::uint8_t*>(encoded.data());
}

}  // namespace

std::optional<glm::ivec2> still_webp_size(std::span<const std::byte> encoded) {
  WebPBitstreamFeatures features;
  const bool known = WebPGetFeatures(bytes_of(encoded), encoded.size(), &features) == VP8_STATUS_OK;
  return known && !features.has_animation ? std::optional(glm::ivec2(features.width, features.height)) : std::nullopt;
}

bool decode_still_webp(std::span<const std::byte> encoded, glm::ivec2 size, std::span<std::uint32_t> texels) {
  auto* bytes = reinterpret_cast<std::uint8_t*>(texels.data());
  return WebPDecodeRGBAInto(bytes_of(encoded), encoded.size(), bytes, texels.size_bytes(), 4 * size.x) != nullptr;
}

}  // namespace vernier
