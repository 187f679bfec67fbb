#pragma once

#include <string>

#include "image/image.h"

namespace vernier {

/// The colour layer of `file`, the layer without a name, as [height][width][4] R G B A. Missing alpha is 1; a lone
/// channel Y is copied to R G B; further channels are left out. NaN and infinity are kept.
/// Throws Error(refused) with `path` where there is no such layer or it is neither R G B nor Y.
Image color_image(const ImageFile& file, const std::string& path);

/// A file of `image` alone, without crop and metadata: 3 channels become R G B, 4 R G B A, 1 Y.
/// Throws Error(failed) for other channel counts.
ImageFile file_of_image(const Image& image);

}  // namespace vernier
