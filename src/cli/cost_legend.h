#pragma once

#include <string>

#include "image/image.h"

namespace vernier {

/// A line that says what the colours of the picture of `image`'s cost layer stand for, and its mean and largest cost;
/// empty without that layer.
std::string cost_legend(const ImageFile& image);

}  // namespace vernier
