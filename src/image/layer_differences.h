#pragma once

#include <string>
#include <vector>

#include "image/image.h"

namespace vernier {

/// In what the layers of `image` differ from those of `original`, bit by bit (a NaN equals one of the same bits), a
/// line each: the number of pixels, the first of them and a value of it. Empty: all are the same. Layers are found by
/// name, their order does not count. Sizes that differ, and layers that only one has, are differences too.
std::vector<std::string> layer_differences(const ImageFile& original, const ImageFile& image);

}  // namespace vernier
