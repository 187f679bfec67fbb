#include "image/essential_png.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstdint>

#include "error.h"
#include "image/png_pixels.h"

namespace vernier {
namespace {

// Length and kind before the content, checksum after it.
constexpr std::size_t kFrameBytes = 12;
constexpr std::size_t kHeaderBytes = 13;
constexpr std::uint8_t kPaletteColor = 3;

struct Chunk {
  std::string kind;
  std::span<const std::byte> framed;   // all of it
  std::span<const std::byte> content;  // without its frame
};

std::uint32_t word_at(std::span<const std::byte> bytes, std::size_t offset) {
  std::uint32_t word = 0;
  for (std::size_t i = 0; i < 4; ++i) word = word << 8 | std::to_integer<std::uint32_t>(bytes[offset + i]);
  return word;
}

Chunk first_chunk(std::span<const std::byte> rest, const std::string& name) {
  if (rest.size() < kFrameBytes) refuse(name, "the PNG file ends within a chunk");
  const std::size_t length = word_at(rest, 0);
  if (length > rest.size() - kFrameBytes) refuse(name, "the PNG file ends within a chunk");
  const auto* kind = reinterpret_cast<const char*>(rest.data() + 4);
  return {std::string(kind, 4), rest.first(length + kFrameBytes), rest.subspan(8, length)};
}

bool is_essential(const std::string& kind, PngText text) {
  if (kind == "tEXt") return text == PngText::kept;
  static constexpr std::array<const char*, 5> kKinds = {"IHDR", "PLTE", "tRNS", "IDAT", "IEND"};
  return std::ranges::find(kKinds, kind) != kKinds.end();
}

void check_sum(const Chunk& chunk, const std::string& name) {
  const auto* summed = reinterpret_cast<const Bytef*>(chunk.framed.data() + 4);
  const uLong sum = crc32(0, summed, static_cast<uInt>(chunk.content.size() + 4));
  if (sum != word_at(chunk.framed, chunk.framed.size() - 4)) {
    refuse(name, "the PNG file is damaged: wrong checksum of a chunk " + chunk.kind);
  }
}

// Bits a channel by kind of colour: table 11.1 of the specification.
bool is_allowed(std::uint8_t depth, std::uint8_t color) {
  const bool small = depth == 1 || depth == 2 || depth == 4;
  if (color == 0) return small || depth == 8 || depth == 16;
  if (color == kPaletteColor) return small || depth == 8;
  return (color == 2 || color == 4 || color == 6) && (depth == 8 || depth == 16);
}

PngLayout checked_layout(const Chunk& chunk, const std::string& name) {
  if (chunk.kind != "IHDR" || chunk.content.size() != kHeaderBytes) refuse(name, "the PNG file has no header");
  const auto byte = [&](std::size_t i) { return std::to_integer<std::uint8_t>(chunk.content[i]); };
  const std::uint32_t width = word_at(chunk.content, 0), height = word_at(chunk.content, 4);
  constexpr std::uint32_t kLargest = 0x7FFFFFFF;
  const bool sized = width > 0 && height > 0 && width <= kLargest && height <= kLargest;
  if (!sized || !is_allowed(byte(8), byte(9)) || byte(10) != 0 || byte(11) != 0 || byte(12) > 1) {
    refuse(name, "the PNG header makes no sense: " + std::to_string(width) + "x" + std::to_string(height) + ", " +
                     std::to_string(byte(8)) + " bits, colour type " + std::to_string(byte(9)));
  }
  return {width, height, byte(8), byte(9), byte(12) == 1};
}

void check_pixels(const PngLayout& layout, std::span<const std::span<const std::byte>> parts, const std::string& name) {
  const std::string fault = png_pixel_fault(layout, parts);
  if (!fault.empty()) refuse(name, "the PNG file is damaged in its pixels: " + fault);
}

void append(std::vector<std::byte>& file, std::span<const std::byte> bytes) {
  file.insert(file.end(), bytes.begin(), bytes.end());
}

}  // namespace

std::vector<std::byte> essential_png(std::span<const std::byte> encoded, const std::string& name,
                                     std::uint64_t most_pixels, PngText text) {
  std::vector<std::byte> file;
  file.reserve(encoded.size() + kFrameBytes);
  append(file, encoded.first(kPngSignature.size()));
  std::span<const std::byte> rest = encoded.subspan(kPngSignature.size());
  PngLayout layout{};
  std::vector<std::span<const std::byte>> pixels;
  bool has_palette = false, ended = false;
  for (std::size_t number = 0; !rest.empty() && !ended; ++number) {
    const Chunk chunk = first_chunk(rest, name);
    rest = rest.subspan(chunk.framed.size());
    if (number > 0 && !is_essential(chunk.kind, text)) continue;
    check_sum(chunk, name);
    if (number == 0) layout = checked_layout(chunk, name);
    has_palette = has_palette || chunk.kind == "PLTE";
    if (chunk.kind == "IDAT") pixels.push_back(chunk.content);
    ended = chunk.kind == "IEND";
    const bool late = !pixels.empty() && chunk.kind != "IDAT" && chunk.kind != "tEXt" && !ended;
    const bool again = number > 0 && chunk.kind == "IHDR";
    if (late || again) refuse(name, "the PNG file is damaged: a chunk " + chunk.kind + " is out of place");
    append(file, chunk.framed);
  }
  if (pixels.empty()) refuse(name, "the PNG file has no pixels");
  if (layout.color == kPaletteColor && !has_palette) refuse(name, "the PNG file has no palette");
  if (std::uint64_t{layout.width} * layout.height <= most_pixels) check_pixels(layout, pixels, name);
  constexpr std::array<unsigned char, kFrameBytes> kEnd = {0, 0, 0, 0, 'I', 'E', 'N', 'D', 0xAE, 0x42, 0x60, 0x82};
  if (!ended) append(file, std::as_bytes(std::span(kEnd)));
  return file;
}

}  // namespace vernier
