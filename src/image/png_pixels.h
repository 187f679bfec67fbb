#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace vernier {

/// What a PNG's header says about its pixels; width and height above zero, depth and colour a pair that is allowed.
struct PngLayout {
  std::uint32_t width, height;
  std::uint8_t depth;  ///< bits per channel
  std::uint8_t color;  ///< colour type: 0, 2, 3, 4 or 6
  bool interlaced;     ///< Adam7
};

/// What is wrong with the compressed pixels that `parts` (the contents of all IDAT chunks in order) hold: a stream that
/// zlib refuses or that ends early, or a row whose filter is none. Empty for none. Bytes too many are none: readers
/// pass over them. Inflates the stream once, in a fixed buffer. W3C, PNG Specification, Third Edition, 8 to 10.
std::string png_pixel_fault(const PngLayout& layout, std::span<const std::span<const std::byte>> parts);

}  // namespace vernier
