#pragma once

#include <OpenImageIO/imageio.h>

#include <cstddef>
#include <functional>
#include <string>

#include "image/file_format.h"

namespace vernier {

/// Fills `bytes` with rows `row_begin` to `row_end` (counted from 0 at the top) in the file's own layout: pixel after
/// pixel, each its channels in order and in their own format.
using FillRows = std::function<void(int row_begin, int row_end, std::byte* bytes)>;

/// Writes `path` whole or not at all (write_whole) as one image of `spec`, whose rows `fill` supplies in blocks from
/// top to bottom. The bytes of the file depend on the arguments only: no time of writing.
/// Throws Error(failed) with `path` and the reason, also when only closing fails.
void write_pixels(const std::string& path, FileFormat format, OIIO::ImageSpec spec, const FillRows& fill);

}  // namespace vernier
