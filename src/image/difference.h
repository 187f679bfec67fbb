#pragma once

#include <array>
#include <cstdint>

#include "image/image.h"

namespace vernier {

/// Of relMSE: keeps black reference pixels from making the relative error infinite (Rousselle et al. 2011, Adaptive
/// Sampling and Reconstruction using Greedy Error Minimization, section 3).
inline constexpr double kRelMseFloor = 0.01;

/// How far an image `a` is from the reference `b`, over linear red, green and blue (alpha is not compared).
/// Pixels with a non-finite colour value in either image are counted and left out of everything else; with no pixel
/// left, the means are NaN, the largest difference 0 and its place (-1, -1).
struct Difference {
  double rmse = 0.0;          ///< square root of the mean over pixels and channels of (a - b)^2
  double rel_mse = 0.0;       ///< mean over pixels and channels of (a - b)^2 / (b^2 + 0.01)
  double psnr_db = 0.0;       ///< -20 log10(rmse): the peak is 1 in linear light; +infinity for rmse 0
  double max_absolute = 0.0;  ///< largest |a - b|
  int max_x = -1;             ///< pixel of the largest difference, the first in row order of equal ones
  int max_y = -1;
  int max_channel = -1;                 ///< 0 red, 1 green, 2 blue
  std::array<double, 3> mean_signed{};  ///< mean of a - b per channel: bias
  std::uint64_t non_finite_a = 0;       ///< pixels of `a` with NaN or infinity in a colour channel
  std::uint64_t non_finite_b = 0;
  std::uint64_t compared_pixels = 0;
  bool finite = true;  ///< no pixel was left out
};

/// Compares `a` with the reference `b`. Sums in double precision, along a row, then over rows: the same on every
/// machine. Images of 1 channel count as grey, of 3 and 4 as R G B (A). Throws Error(usage) where the sizes differ, an
/// image has no pixels, another number of channels, or not as many values as that makes.
Difference compare_images(const Image& a, const Image& b);

}  // namespace vernier
