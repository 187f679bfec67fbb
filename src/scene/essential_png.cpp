#include "scene/essential_png.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>

#include "error.h"
#include "scene/texture_from_image.h"

namespace vernier {
namespace {

constexpr std::string_view kSignature("\x89PNG\r\n\x1a\n", 8);
constexpr std::array<unsigned char, 12> kEnd = {0, 0, 0, 0, 'I', 'E', 'N', 'D', 0xAE, 0x42, 0x60, 0x82};

// Of pictures that are too large nothing is inflated: the reader refuses them by their size.
void check_pixels(const PngChunks& chunks, const std::string& name) {
  if (std::uint64_t{chunks.layout.width} * chunks.layout.height > kMaxTexels) return;
  const std::string fault = png_pixel_fault(chunks.layout, chunks.pixels);
  if (!fault.empty()) throw Error(ErrorKind::refused, name + ": the PNG file is damaged in its pixels: " + fault);
}

void append(std::vector<std::byte>& file, std::span<const std::byte> bytes) {
  std::ranges::copy(bytes, std::back_inserter(file));
}

}  // namespace

std::vector<std::byte> essential_png(const PngChunks& chunks, const std::string& name) {
  check_pixels(chunks, name);
  std::vector<std::byte> file;
  append(file, std::as_bytes(std::span(kSignature)));
  for (const std::span<const std::byte> chunk : chunks.framed) append(file, chunk);
  if (!chunks.ended) append(file, std::as_bytes(std::span(kEnd)));
  return file;
}

}  // namespace vernier
