#pragma once

#include <string>

#include "image/display_picture.h"
#include "image/image.h"

namespace vernier {

/// Writes `image` in the format that the extension of `path` names (file_format).
///
/// EXR: every layer in one single-part file, float32 or uint32 as the layer is, zip (lossless), crop as data window,
/// full image as display window, metadata as text attributes; NaN and infinity are kept. Linear, `display` is unused.
///
/// The others get the layer without a name as `path` and each further layer as a file of its own, layer_path:
/// TIFF: raw float32 or uint32 with all channels, NaN and infinity kept; zip. HDR: linear RGB of unsigned_picture,
/// 8 bits of mantissa shared by the channels. PNG and JPEG (quality 95, full chroma): display_picture, 8 bits rounded
/// to nearest. They do not hold the crop. Metadata are text_of_metadata as the image description, with the
/// name of the layer, where it has one, as `vernier:layer`; HDR holds none, nor
/// does JPEG beyond 60000 bytes.
///
/// Equal arguments make equal bytes. Each file is written whole or not at all; where a later one fails, earlier ones
/// stay. Throws Error(usage) for an unknown extension or exposure, Error(failed) with the path for everything that does
/// not fit (no layer, sizes that disagree, a channel twice) and for every failure to write (write_whole).
void write_image(const std::string& path, const ImageFile& image, const DisplayTransform& display);

/// Where write_image puts the layer `layer_name` in formats of one layer a file: `NAME.LAYER.EXT` for `NAME.EXT`,
/// `path` itself for an empty name.
std::string layer_path(const std::string& path, const std::string& layer_name);

}  // namespace vernier
