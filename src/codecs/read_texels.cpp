#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <functional>
#include <memory>
#include <new>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "codecs/jpeg_fault.h"
#include "codecs/texel_layout.h"
#include "codecs/webp_image.h"
#include "error.h"
#include "image/srgb_curve.h"
#include "scene/texel_codec.h"

namespace vernier {
namespace {

/// Rows read at once: enough to make a call's overhead small.
constexpr int kBandRows = 64;

std::string one_line(std::string text) {
  for (char& c : text) {
    if (c == '\n' || c == '\r' || c == '\t') c = ' ';
  }
  // Readers add the name that they were given.
  if (const std::size_t made_up = text.find(" (\"texture."); made_up != std::string::npos) text.resize(made_up);
  while (!text.empty() && text.back() == ' ') text.pop_back();
  return text.empty() ? "unknown format" : text;
}

void check_size(int width, int height, const std::string& name) {
  if (width > kMaxTextureSide_px || height > kMaxTextureSide_px ||
      std::uint64_t(width) * std::uint64_t(height) > kMaxTexels) {
    refuse(name, std::to_string(width) + "x" + std::to_string(height) + " texels are more than " +
                     std::to_string(kMaxTexels) + " or a side is longer than " + std::to_string(kMaxTextureSide_px));
  }
}

void check_spec(const OIIO::ImageSpec& spec, const std::string& name) {
  if (spec.width <= 0 || spec.height <= 0 || spec.depth > 1 || spec.nchannels <= 0) {
    refuse(name, "not an image of width, height and channels above zero");
  }
  check_size(spec.width, spec.height, name);
}

/// Texels that a byte can stand for, at most, in formats that pack by runs or not at all. The others can say in few
/// bytes that an image is of one colour.
std::uint64_t most_texels_of_byte(const std::string& format) {
  if (format == "dds") return 2;                       // 16 in blocks of 8 bytes
  if (format == "ppm") return 8;                       // bitmaps
  if (format == "hdr") return 16;                      // 127 texels in runs of two bytes for each channel
  if (format == "tga" || format == "bmp") return 128;  // 255 of a BMP in runs of two bytes
  return kMaxTexels;
}

void check_length(const OIIO::ImageSpec& spec, std::size_t bytes, const std::string& format, const std::string& name) {
  if (std::uint64_t(spec.width) * std::uint64_t(spec.height) / most_texels_of_byte(format) > bytes) {
    refuse(name,
           "the file is too short for " + std::to_string(spec.width) + "x" + std::to_string(spec.height) + " texels");
  }
}

// Readers claim success for rows that are cut off (TIFF, JPEG), but note a fault. Of JPEG they note stray bytes too,
// which take nothing away.
bool loses_rows(const OIIO::ImageInput& input, const std::string& fault) {
  if (std::string_view(input.format_name()) == "jpeg") return is_cut_jpeg(fault);
  return !fault.empty();
}

// Read in bands: the only large allocation is the result, whose size has been checked. A tiled image (EXR, TIFF) is
// read a row of tiles at a time.
template <typename T, typename StoreTexel>
void read_bands(OIIO::ImageInput& input, const OIIO::ImageSpec& spec, const TexelLayout& layout,
                const std::string& name, StoreTexel store) {
  const auto channels = std::size_t(layout.channel_count);
  const int end_channel = layout.first_channel + layout.channel_count;
  const auto type = OIIO::BaseTypeFromC<T>::value;
  const int band_rows =
      spec.tile_width > 0 ? std::clamp(spec.tile_height, 1, spec.height) : std::min(kBandRows, spec.height);
  std::vector<T> band(std::size_t(spec.width) * std::size_t(band_rows) * channels);
  // What was said before is about other things, but a progressive JPEG is decoded when it is opened.
  if (const std::string fault = input.geterror(); is_cut_jpeg(fault))
    refuse(name, "the image cannot be read: " + one_line(fault));
  for (int row = 0; row < spec.height; row += band_rows) {
    const int end = std::min(row + band_rows, spec.height);
    const bool ok = spec.tile_width > 0
                        ? input.read_tiles(0, 0, spec.x, spec.x + spec.width, spec.y + row, spec.y + end, 0, 1,
                                           layout.first_channel, end_channel, type, band.data())
                        : input.read_scanlines(0, 0, spec.y + row, spec.y + end, 0, layout.first_channel, end_channel,
                                               type, band.data());
    const std::string fault = input.geterror();
    if (!ok || loses_rows(input, fault)) refuse(name, "the image cannot be read: " + one_line(fault));
    const T* values = band.data();
    for (int y = row; y < end; ++y) {
      for (int x = 0; x < spec.width; ++x, values += channels) {
        if (const std::optional<std::size_t> texel = layout.texel_of(x, y)) store(*texel, values);
      }
    }
  }
}

/// Red, green, blue and alpha of a pixel; a missing blue is 0, a missing alpha `opaque`.
template <typename T>
std::array<T, 4> stored_color(const T* values, const TexelLayout& layout, T opaque) {
  std::array<T, 4> color = {0, 0, 0, opaque};
  for (std::size_t c = 0; c < 4; ++c) {
    if (layout.channels[c] >= 0) color[c] = values[layout.channels[c]];
  }
  return color;
}

void read_bytes(OIIO::ImageInput& input, const OIIO::ImageSpec& spec, const TexelLayout& layout,
                const std::string& name, Texels& texels) {
  texels.words.resize(std::size_t(layout.width) * std::size_t(layout.height));
  read_bands<std::uint8_t>(input, spec, layout, name, [&](std::size_t texel, const std::uint8_t* values) {
    const std::array<std::uint8_t, 4> color = stored_color<std::uint8_t>(values, layout, 255);
    const std::uint32_t alpha = color[3];
    std::uint32_t word = alpha << 24;
    for (std::size_t c = 0; c < 3; ++c) {
      std::uint32_t value = color[c];
      if (layout.divides_by_alpha && alpha > 0) value = std::min((value * 255u + alpha / 2) / alpha, 255u);
      word |= value << (8 * c);
    }
    texels.words[texel] = word;
  });
}

void read_floats(OIIO::ImageInput& input, const OIIO::ImageSpec& spec, const TexelLayout& layout,
                 const std::string& name, bool decode_srgb, Texels& texels) {
  texels.format = TEXTURE_FORMAT_FLOAT;
  texels.words.resize(std::size_t(layout.width) * std::size_t(layout.height) * 4);
  read_bands<float>(input, spec, layout, name, [&](std::size_t texel, const float* values) {
    const std::array<float, 4> color = stored_color(values, layout, 1.0f);
    for (std::size_t c = 0; c < 4; ++c) {
      float value = layout.is_negative && c < 3 ? 1.0f - color[c] : color[c];
      if (layout.divides_by_alpha && c < 3 && color[3] > 0.0f) value /= color[3];
      if (!std::isfinite(value)) value = 0.0f;
      if (decode_srgb && c < 3) value = static_cast<float>(linear_from_srgb(value));
      texels.words[texel * 4 + c] = std::bit_cast<std::uint32_t>(value);
    }
  });
}

std::uint32_t byte_format(TexelEncoding encoding) {
  return encoding == TexelEncoding::linear ? TEXTURE_FORMAT_LINEAR8 : TEXTURE_FORMAT_SRGB8;
}

void decode_webp(std::span<const std::byte> encoded, const glm::ivec2& size, const std::string& name,
                 TexelEncoding encoding, const std::function<void(std::uint64_t)>& claim, Texels& texels) {
  check_size(size.x, size.y, name);
  claim(std::uint64_t(size.x) * std::uint64_t(size.y) * 4);
  texels.width = std::uint32_t(size.x);
  texels.height = std::uint32_t(size.y);
  texels.format = byte_format(encoding);
  texels.words.resize(std::size_t(texels.width) * texels.height);
  if (!decode_still_webp(encoded, size, texels.words)) refuse(name, "the image cannot be read");
}

/// The reader of `format` with `memory` open, which outlives it; `spec` is what it tells of the image.
std::unique_ptr<OIIO::ImageInput> open_image(OIIO::Filesystem::IOMemReader& memory, const std::string& format,
                                             const std::string& name, OIIO::ImageSpec& spec) {
  OIIO::ImageSpec config;
  config.attribute("oiio:UnassociatedAlpha", 1);
  // Some readers take a proxy only so, some only as an attribute, and would open a file of the name otherwise.
  OIIO::Filesystem::IOProxy* proxy = &memory;
  config.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &proxy);
  std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::create(format);
  if (!input || !input->supports("ioproxy") || !input->set_ioproxy(&memory) ||
      !input->open("texture." + format, spec, config)) {
    OIIO::geterror();  // empties OpenImageIO's queue of messages
    refuse(name, "not an image in a format that can be read");
  }
  return input;
}

void decode(std::span<const std::byte> encoded, const std::string& format, const std::string& name,
            TexelEncoding encoding, const std::function<void(std::uint64_t)>& claim, Texels& texels) {
  if (const std::optional<glm::ivec2> size = still_webp_size(encoded)) {
    decode_webp(encoded, *size, name, encoding, claim, texels);
    return;
  }
  OIIO::Filesystem::IOMemReader memory(const_cast<std::byte*>(encoded.data()), encoded.size());
  OIIO::ImageSpec spec;
  const std::unique_ptr<OIIO::ImageInput> input = open_image(memory, format, name, spec);
  check_spec(spec, name);
  check_length(spec, encoded.size(), format, name);
  TexelLayout layout = texel_layout(spec, format, encoded, name);
  layout.divides_by_alpha &= encoding == TexelEncoding::srgb;
  check_size(layout.width, layout.height, name);

  texels.width = std::uint32_t(layout.width);
  texels.height = std::uint32_t(layout.height);
  const bool is_float = spec.format.is_floating_point();
  const bool is_bytes = !is_float && spec.format.size() == 1;
  claim(std::uint64_t(texels.width) * texels.height * (is_bytes ? 4 : 16));
  if (is_bytes) {
    texels.format = byte_format(encoding);
    read_bytes(*input, spec, layout, name, texels);
  } else {
    read_floats(*input, spec, layout, name, !is_float && encoding != TexelEncoding::linear, texels);
  }
}

}  // namespace

void read_texels(std::span<const std::byte> encoded, const std::string& format, const std::string& name,
                 TexelEncoding encoding, const std::function<void(std::uint64_t)>& claim, Texels& texels) {
  try {
    decode(encoded, format, name, encoding, claim, texels);
  } catch (const std::bad_alloc&) {  // not the image's fault
    throw MemoryError(name + ": not enough memory for its pixels");
  } catch (const std::length_error&) {  // of a reader that believes its header
    refuse(name, "not enough memory for its pixels");
  }
}

}  // namespace vernier
