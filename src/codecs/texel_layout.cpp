#include "codecs/texel_layout.h"

#include <algorithm>
#include <cctype>
#include <cstdint>

#include "error.h"
#include "math/little_endian.h"

namespace vernier {
namespace {

/// A BMP's fourth byte is alpha only where its header has a mask for it.
bool bmp_has_alpha(std::span<const std::byte> encoded) {
  constexpr std::size_t kHeaderSize = 14, kCompression = 30, kAlphaMask = 66;
  constexpr std::uint32_t kWithMask = 56, kBitFields = 3;
  return encoded.size() >= kAlphaMask + 4 && little_endian(encoded, kHeaderSize) >= kWithMask &&
         little_endian(encoded, kCompression) == kBitFields && little_endian(encoded, kAlphaMask) != 0;
}

/// Whether `name` is the channel `letter` of the layer `prefix` (empty, or with a point at its end).
bool is_channel(const std::string& name, const std::string& prefix, char letter) {
  return name.size() == prefix.size() + 1 && name.starts_with(prefix) &&
         std::toupper(static_cast<unsigned char>(name.back())) == letter;
}

int channel_of(const OIIO::ImageSpec& spec, const std::string& prefix, char letter) {
  const auto found = std::ranges::find_if(spec.channelnames,
                                          [&](const std::string& name) { return is_channel(name, prefix, letter); });
  return found == spec.channelnames.end() ? -1 : static_cast<int>(found - spec.channelnames.begin());
}

/// The first layer that has red: empty or with a point at its end.
std::optional<std::string> layer_with_red(const OIIO::ImageSpec& spec) {
  for (const std::string& name : spec.channelnames) {
    const std::string prefix = name.substr(0, name.find_last_of('.') + 1);
    if (is_channel(name, prefix, 'R')) return prefix;
  }
  return std::nullopt;
}

/// By their names, as EXR has them: colours of one layer, with its alpha; one alone is grey.
std::optional<std::array<int, 4>> named_channels(const OIIO::ImageSpec& spec) {
  if (const std::optional<std::string> layer = layer_with_red(spec)) {
    const int red = channel_of(spec, *layer, 'R'), green = channel_of(spec, *layer, 'G');
    const int blue = channel_of(spec, *layer, 'B'), alpha = channel_of(spec, *layer, 'A');
    if (green < 0 && blue < 0) return std::array{red, red, red, alpha};
    return std::array{red, green, blue, alpha};
  }
  const int grey = channel_of(spec, "", 'Y');  // but for the second of a vector's X, Y and Z
  if (grey < 0 || channel_of(spec, "", 'X') >= 0) return std::nullopt;
  return std::array{grey, grey, grey, channel_of(spec, "", 'A')};
}

/// The first three channels that are not `alpha` (-1: none), or the first as grey.
std::array<int, 4> counted_channels(int count, int alpha) {
  const int grey = alpha == 0 && count > 1 ? 1 : 0;
  if (count - (alpha >= 0 ? 1 : 0) < 3) return {grey, grey, grey, alpha};
  return {0, 1, 2, alpha > 2 ? alpha : -1};
}

/// Reads no more channels than are asked for.
void set_channels(const std::array<int, 4>& channels, TexelLayout& layout) {
  layout.first_channel = *std::ranges::max_element(channels);
  for (const int channel : channels) {
    if (channel >= 0) layout.first_channel = std::min(layout.first_channel, channel);
  }
  layout.channel_count = *std::ranges::max_element(channels) - layout.first_channel + 1;
  layout.channels = channels;
  for (int& channel : layout.channels) channel = channel < 0 ? -1 : channel - layout.first_channel;
}

/// Of EXR, whose pixels may be a part of the picture, or more than it. A window that shows none of them says nothing.
void place_in_display_window(const OIIO::ImageSpec& spec, const std::string& name, TexelLayout& layout) {
  constexpr std::int64_t kLargeWindow = std::int64_t{1} << 22, kMostTimes = 16;
  const std::int64_t left = std::int64_t{spec.x} - spec.full_x, top = std::int64_t{spec.y} - spec.full_y;
  const bool shows_some =
      left < spec.full_width && top < spec.full_height && left + spec.width > 0 && top + spec.height > 0;
  if (!shows_some) return;
  const std::int64_t window = std::int64_t{spec.full_width} * spec.full_height;
  if (window > kLargeWindow && window / kMostTimes > std::int64_t{spec.width} * spec.height) {
    refuse(name, "its display window is " + std::to_string(kMostTimes) + " times as large as what it holds");
  }
  layout.width = spec.full_width;
  layout.height = spec.full_height;
  layout.left = static_cast<int>(left);
  layout.top = static_cast<int>(top);
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
  int alpha = format == "bmp" && !bmp_has_alpha(encoded) ? -1 : spec.alpha_channel;
  const bool is_alpha_named = alpha >= 0;
  // Photoshop leaves the kind of a TIFF's last sample open: who makes a cut-out so means alpha.
  if (is_tiff && alpha < 0 && (spec.nchannels == 2 || spec.nchannels == 4)) alpha = spec.nchannels - 1;
  TexelLayout layout;
  layout.width = spec.width;
  layout.height = spec.height;
  const std::optional<std::array<int, 4>> named = is_exr ? named_channels(spec) : std::nullopt;
  const std::array<int, 4> channels = named.value_or(counted_channels(spec.nchannels, is_exr ? -1 : alpha));
  set_channels(channels, layout);
  const bool is_associated_tiff = is_tiff && is_alpha_named && !spec.get_int_attribute("oiio:UnassociatedAlpha");
  layout.divides_by_alpha = channels[3] >= 0 && (is_exr || is_associated_tiff);
  // OpenImageIO turns those of up to 8 bits round by itself.
  layout.is_negative =
      is_tiff && spec.get_int_attribute("tiff:PhotometricInterpretation", 1) == 0 && spec.format.size() > 1;
  if (is_exr) place_in_display_window(spec, name, layout);
  if (format == "hdr") orient(spec, name, layout);
  return layout;
}

}  // namespace vernier
