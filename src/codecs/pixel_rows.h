#pragma once

#include <OpenImageIO/imageio.h>

#include <cstddef>
#include <functional>
#include <string>

namespace vernier {

/// Takes `row_count` whole rows in the file's own layout: pixel after pixel, each its channels in order and in their
/// own format.
using TakeRows = std::function<void(const std::byte* bytes, int row_count)>;

/// Reads all pixels of `input` (scanlines or tiles) from top to bottom in blocks of rows and hands them to `take`.
/// Throws Error(refused) with `path` and the codec's reason at the first block that does not decode.
void read_rows(const std::string& path, OIIO::ImageInput& input, const TakeRows& take);

/// Channel `channel` of the pixel at `pixel` as a number: floats and halves as they are, integers up to 16 bits divided
/// by their largest value (uint8, uint16; the only ones such files hold), uint32 as a count. `byte_offset` is where the
/// channel starts in the pixel.
double value_of(const std::byte* pixel, std::size_t byte_offset, OIIO::TypeDesc type);

}  // namespace vernier
