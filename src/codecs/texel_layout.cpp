#include "codecs/texel_layout.h"

#include <algorithm>

#include "error.h"

namespace vernier {
namespace {

std::uint32_t word_at(std::span<const std::byte> bytes, std::size_t offset) {
  if (bytes.size() < offset + 4) return 0;
  std::uint32_t word = 0;
  for (std::size_t i = 0; i < 4; ++i) word |= std::to_integer<std::uint32_t>(bytes[offset + i]) << (8 * i);
  return word;
}

/// A BMP's fourth byte is alpha only where its header has a mask for it.
bool bmp_has_alpha(std::span<const std::byte> encoded) {
  constexpr std::size_t kHeaderSize = 14, kCompression = 30, kAlphaMask = 66;
  constexpr std::uint32_t kWithMask = 56, kBitFields = 3;
  return word_at(encoded, kHeaderSize) >= kWithMask && word_at(encoded, kCompression) == kBitFields &&
         word_at(encoded, kAlphaMask) != 0;
}

int channel_of(const OIIO::ImageSpec& spec, const char* name) {
  const auto found = std::ranges::find(spec.channelnames, name);
  return found == spec.channelnames.end() ? -1 : static_cast<int>(found - spec.channelnames.begin());
}

/// Colours by their names where the format names them, else the first three, or one that is grey.
std::array<int, 4> channels_of(const OIIO::ImageSpec& spec, int alpha, bool named) {
  const int red = channel_of(spec, "R"), green = channel_of(spec, "G"), blue = channel_of(spec, "B");
  if (named && red >= 0) return {red, green, blue, alpha};
  const int colors = spec.nchannels - (alpha >= 0 ? 1 : 0);
  if (colors >= 3) return {0, 1, 2, alpha};
  const int grey = alpha == 0 && spec.nchannels > 1 ? 1 : 0;
  return {grey, grey, grey, alpha};
}

/// Of EXR, whose pixels may be a part of the picture, or more than it.
void place_in_display_window(const OIIO::ImageSpec& spec, TexelLayout& layout) {
  if (spec.full_width < 1 || spec.full_height < 1) return;
  layout.width = spec.full_width;
  layout.height = spec.full_height;
  layout.left = spec.x - spec.full_x;
  layout.top = spec.y - spec.full_y;
}

/// Of Radiance HDR, whose first line says where rows and columns begin: as EXIF's orientation. (EXIF's own does not
/// count in textures: glTF 2.0, 3.8.3.)
void orient(const OIIO::ImageSpec& spec, const std::string& name, TexelLayout& layout) {
  constexpr int kRightTop = 2, kRightBottom = 3, kLeftBottom = 4;
  const int orientation = spec.get_int_attribute("Orientation", 1);
  if (orientation > kLeftBottom) refuse(name, "its pixels are stored column by column, which is not supported");
  layout.flips_x = orientation == kRightTop || orientation == kRightBottom;
  layout.flips_y = orientation == kRightBottom || orientation == kLeftBottom;
}

}  // namespace

int TexelLayout::channel_count() const {
  return std::ranges::max(channels) + 1;
}

std::optional<std::size_t> TexelLayout::texel_of(int x, int y) const {
  const int column = flips_x ? width - 1 - (x + left) : x + left;
  const int row = flips_y ? height - 1 - (y + top) : y + top;
  if (column < 0 || column >= width || row < 0 || row >= height) return std::nullopt;
  return std::size_t(row) * std::size_t(width) + std::size_t(column);
}

TexelLayout texel_layout(const OIIO::ImageSpec& spec, const std::string& format, std::span<const std::byte> encoded,
                         const std::string& name) {
  const bool is_exr = format == "exr";
  const bool is_tiff = format == "tif";
  const bool has_alpha = spec.alpha_channel >= 0 && (format != "bmp" || bmp_has_alpha(encoded));
  TexelLayout layout;
  layout.width = spec.width;
  layout.height = spec.height;
  layout.channels = channels_of(spec, has_alpha ? spec.alpha_channel : -1, is_exr);
  layout.divides_by_alpha = has_alpha && (is_exr || (is_tiff && !spec.get_int_attribute("oiio:UnassociatedAlpha")));
  // OpenImageIO turns those of up to 8 bits round by itself.
  layout.is_negative =
      is_tiff && spec.get_int_attribute("tiff:PhotometricInterpretation", 1) == 0 && spec.format.size() > 1;
  if (is_exr) place_in_display_window(spec, layout);
  if (format == "hdr") orient(spec, name, layout);
  return layout;
}

}  // namespace vernier
