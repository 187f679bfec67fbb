#pragma once

#include <string>

#include "image/display_picture.h"
#include "image/file_format.h"
#include "image/image.h"

// What the module of codecs does with image files. Called through `codec` (image/codec_module.h) alone: by name, so
// that the program starts without it.

namespace vernier {

extern "C" {

/// read_image, of a file in `format`.
[[gnu::visibility("default")]] void read_image_file(const std::string& path, FileFormat format, ImageFile& image);

/// Writes `image`, whose sizes agree, as the EXR file `path` as write_image promises it.
[[gnu::visibility("default")]] void write_exr_file(const std::string& path, const ImageFile& image);

/// Writes the layer `layer` of `image`, whose sizes agree, as the file `path` in `format`, one of those without layers,
/// as write_image promises it.
[[gnu::visibility("default")]] void write_layer_file(const std::string& path, FileFormat format, const ImageFile& image,
                                                     const Layer& layer, const DisplayTransform& display);

}  // extern "C"

}  // namespace vernier
