#include "codecs/pixel_rows.h"

#include <algorithm>
#include <cstring>
#include <vector>

#include "codecs/jpeg_fault.h"
#include "error.h"

namespace vernier {
namespace {

constexpr int kRowsPerBlock = 64;

template <typename Value>
Value load(const std::byte* bytes) {
  Value value;
  std::memcpy(&value, bytes, sizeof(Value));
  return value;
}

// A block of tiles is as high as the tiles and reaches to the right edge of the picture.
bool read_block(OIIO::ImageInput& input, const OIIO::ImageSpec& spec, int y_begin, int y_end, std::byte* bytes) {
  if (spec.tile_width == 0)
    return input.read_scanlines(0, 0, y_begin, y_end, 0, 0, spec.nchannels, OIIO::TypeUnknown, bytes);
  return input.read_tiles(0, 0, spec.x, spec.x + spec.width, y_begin, y_end, 0, 1, 0, spec.nchannels, OIIO::TypeUnknown,
                          bytes);
}

[[noreturn]] void refuse_rows(const std::string& place, std::string reason) {
  std::ranges::replace(reason, '\n', ' ');
  throw Error(ErrorKind::refused, place + ": " + reason);
}

}  // namespace

void read_rows(const std::string& path, OIIO::ImageInput& input, const TakeRows& take) {
  const OIIO::ImageSpec spec = input.spec();
  const int rows_per_block = std::min(spec.tile_width == 0 ? kRowsPerBlock : spec.tile_height, spec.height);
  std::vector<std::byte> bytes(spec.scanline_bytes(true) * rows_per_block);
  // What was said before is about other things, but a progressive JPEG is decoded when it is opened.
  if (const std::string fault = input.geterror(); is_cut_jpeg(fault)) refuse_rows(path, fault);
  for (int row = 0; row < spec.height; row += rows_per_block) {
    const int row_count = std::min(rows_per_block, spec.height - row);
    // The TIFF reader claims success for strips that are cut off, but it notes the error.
    if (!read_block(input, spec, spec.y + row, spec.y + row + row_count, bytes.data()) || input.has_error()) {
      const std::string reason = input.geterror();
      refuse_rows(path + ": row " + std::to_string(row), reason.empty() ? "cannot be decoded" : reason);
    }
    take(bytes.data(), row_count);
  }
}

double value_of(const std::byte* pixel, std::size_t byte_offset, OIIO::TypeDesc type) {
  const std::byte* bytes = pixel + byte_offset;
  float widened = 0.0f;
  switch (type.basetype) {
    case OIIO::TypeDesc::FLOAT:
      return load<float>(bytes);
    case OIIO::TypeDesc::DOUBLE:
      return load<double>(bytes);
    case OIIO::TypeDesc::HALF:
      OIIO::convert_pixel_values(type, bytes, OIIO::TypeDesc::FLOAT, &widened, 1);
      return widened;
    case OIIO::TypeDesc::UINT8:
      return load<std::uint8_t>(bytes) / 255.0;
    case OIIO::TypeDesc::UINT16:
      return load<std::uint16_t>(bytes) / 65535.0;
    default:
      return load<std::uint32_t>(bytes);
  }
}

}  // namespace vernier
