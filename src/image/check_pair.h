#pragma once

#include <array>
#include <cstddef>

#include "image/image.h"

namespace vernier {

/// Throws Error(usage) unless `a` and `b` can be compared: the same size, at least one pixel, 1, 3 or 4 channels each,
/// and as many values as that makes.
void check_pair(const Image& a, const Image& b);

/// Red, green and blue of the pixel with index `pixel` in row order; a single channel is grey. `image` has passed
/// check_pair.
std::array<double, 3> rgb_of_pixel(const Image& image, std::size_t pixel);

}  // namespace vernier
