#pragma once

#include <cstdint>
#include <string>

#include "image/image.h"

namespace vernier {

/// Most values (pixels x channels) of a file that read_image accepts.
inline constexpr std::int64_t kMostImageValues = std::int64_t{1} << 31;

/// Reads the image file `path`; its extension says the format (file_format).
///
/// EXR: channels are split into layers at their last dot, the layer without a name first, then by name. Within a layer
/// R G B A, X Y Z and U V stand in this order, others by name. A layer of uint32 channels only is uint32, any other is
/// float32 (half is widened exactly, uint32 beside floats is rounded). Data and display window, NaN and infinity
/// are kept, text attributes become metadata.
///
/// Other formats give one layer without a name. TIFF of float: values as they are; of uint32: a uint32 layer; channels
/// R G B A or, where there are less than three or more than four, Y, Y A or numbers. HDR: R G B. Integers of 8 and 16
/// bits are decoded from the sRGB curve to linear [0, 1], grey copied to R G B, alpha (not on the curve) kept beside
/// and not multiplied in. Metadata are those that write_image stored. There is no crop.
///
/// Throws Error(refused) with `path` and the reason: not there or not readable, unknown extension, broken or cut off,
/// no pixels, more than kMostImageValues values, several parts or pages, deep or volumetric pixels, not enough memory;
/// and what codec_address does.
/// Memory is filled only as far as the file really holds pixels.
ImageFile read_image(const std::string& path);

}  // namespace vernier
