#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "scene/png_pixels.h"

namespace vernier {

/// What a PNG file's pixels need of it.
struct PngChunks {
  PngLayout layout{};
  std::span<const std::byte> palette;              ///< PLTE: red, green, blue of each entry; empty for none
  std::span<const std::byte> transparency;         ///< tRNS; empty for none
  std::vector<std::span<const std::byte>> pixels;  ///< of all IDAT in order, at least one
  std::vector<std::span<const std::byte>> framed;  ///< the essential chunks in order, with their frames
  bool ended = false;                              ///< IEND is there
};

/// The chunks of the file `encoded`, which begins with a PNG signature and outlives them: IHDR, PLTE, tRNS, IDAT, IEND,
/// checked for lengths, checksums, order and a header that makes sense. Throws Error(refused) "`name`: ..." for a file
/// that is damaged. W3C, PNG Specification, Third Edition.
PngChunks read_png_chunks(std::span<const std::byte> encoded, const std::string& name);

}  // namespace vernier
