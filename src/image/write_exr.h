#pragma once

#include <string>

#include "image/image.h"

namespace vernier {

/// Writes all layers of `image` as one OpenEXR file, as write_image describes. `image` has at least one layer, each
/// with as many values as pixels and channels say, and no channel twice. Throws Error(failed) with `path`.
void write_exr(const std::string& path, const ImageFile& image);

}  // namespace vernier
