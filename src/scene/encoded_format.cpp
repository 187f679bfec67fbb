#include "scene/encoded_format.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "error.h"
#include "image/file_format.h"
#include "math/little_endian.h"

namespace vernier {
namespace {

using namespace std::string_view_literals;

struct Signature {
  std::string_view bytes;
  std::size_t offset;
  const char* format;
};

constexpr std::array kSignatures{Signature{"\x89PNG\r\n\x1a\n"sv, 0, "png"},
                                 Signature{"\xff\xd8\xff"sv, 0, "jpg"},
                                 Signature{"WEBP"sv, 8, "webp"},
                                 Signature{"BM"sv, 0, "bmp"},
                                 Signature{"#?"sv, 0, "hdr"},
                                 Signature{"\x76\x2f\x31\x01"sv, 0, "exr"},
                                 Signature{"II*\0"sv, 0, "tif"},
                                 Signature{"MM\0*"sv, 0, "tif"},
                                 Signature{"GIF8"sv, 0, "gif"},
                                 Signature{"DDS "sv, 0, "dds"},
                                 Signature{"\0\0\0\x0cjP  "sv, 0, "jp2"}};

/// The largest palette index of the pixels from `place` on; run-length packets where `is_packed`.
std::uint32_t largest_index(std::span<const std::byte> encoded, std::size_t place, std::size_t pixels, bool is_packed) {
  std::uint32_t largest = 0;
  while (pixels > 0 && place < encoded.size()) {
    const std::uint32_t packet = is_packed ? std::to_integer<std::uint32_t>(encoded[place++]) : 0;
    const std::size_t covered = is_packed ? (packet & 127u) + 1 : pixels;
    const std::size_t stored = (packet & 128u) != 0 ? 1 : covered;
    for (const std::byte index : encoded.subspan(place, std::min(stored, encoded.size() - place))) {
      largest = std::max(largest, std::to_integer<std::uint32_t>(index));
    }
    place += stored;
    pixels -= std::min(covered, pixels);
  }
  return largest;
}

// OpenImageIO 2.4 takes the colour of an index wherever it lies.
void check_tga(std::span<const std::byte> encoded, const std::string& name) {
  constexpr std::size_t kHeaderBytes = 18;
  if (encoded.size() < kHeaderBytes) refuse(name, "the image is cut short");
  const std::uint32_t type = little_endian(encoded, 2, 1);
  const bool is_packed = type == 9;
  if (type != 1 && !is_packed) return;
  const std::uint32_t first = little_endian(encoded, 3, 2), colors = little_endian(encoded, 5, 2);
  const std::uint32_t index_bits = little_endian(encoded, 16, 1);
  const std::size_t palette_bytes = std::size_t{colors} * ((little_endian(encoded, 7, 1) + 7) / 8);
  const std::size_t pixels = std::size_t{little_endian(encoded, 12, 2)} * little_endian(encoded, 14, 2);
  const std::size_t place = kHeaderBytes + little_endian(encoded, 0, 1) + palette_bytes;
  if (first != 0 || index_bits != 8 || largest_index(encoded, place, pixels, is_packed) >= colors) {
    refuse(name, "its colours lie outside its palette");
  }
}

// OpenImageIO 2.4 looks for the lowest bit of a mask of 0 for ever.
void check_dds(std::span<const std::byte> encoded, const std::string& name) {
  constexpr std::size_t kHeaderBytes = 128;
  constexpr std::uint32_t kHasAlpha = 1, kHasCode = 4, kIsRgb = 64;
  if (encoded.size() < kHeaderBytes) refuse(name, "the image is cut short");
  const std::uint32_t flags = little_endian(encoded, 80);
  const std::string_view code(reinterpret_cast<const char*>(encoded.data()) + 84, 4);
  const std::array masks{little_endian(encoded, 92), little_endian(encoded, 96), little_endian(encoded, 100)};
  const bool is_known = (flags & kHasCode) != 0
                            ? code == "DXT1" || code == "DXT3" || code == "DXT5"
                            : (flags & kIsRgb) != 0 && std::ranges::find(masks, 0u) == masks.end() &&
                                  ((flags & kHasAlpha) == 0 || little_endian(encoded, 104) != 0);
  if (!is_known) refuse(name, "DDS images are read with DXT1, DXT3, DXT5 or plain RGB alone");
}

}  // namespace

std::string encoded_format(std::span<const std::byte> encoded, const std::string& name) {
  for (const Signature& one : kSignatures) {
    if (encoded.size() < one.offset + one.bytes.size()) continue;
    if (std::memcmp(encoded.data() + one.offset, one.bytes.data(), one.bytes.size()) != 0) continue;
    if (one.format == "dds"sv) check_dds(encoded, name);
    return one.format;
  }
  const std::string extension = lower_case_extension(name);
  if (extension == ".ppm" || extension == ".pgm" || extension == ".pnm") return "ppm";
  // A name without extension is that of an image in a buffer: nothing else says what TGA is.
  if (extension != ".tga" && extension.size() > 1) refuse(name, "not an image in a format that can be read");
  check_tga(encoded, name);
  return "tga";
}

}  // namespace vernier
