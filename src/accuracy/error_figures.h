#pragma once

#include <cstdint>

#include "image/flip.h"
#include "image/image.h"

namespace vernier {

/// How far one picture is from the reference.
struct ErrorFigures {
  double rel_error = 0.0;  ///< sqrt(relMSE), what --error-target bounds
  double rmse = 0.0;
  double rel_mse = 0.0;
  double psnr_db = 0.0;
  double flip_mean = 0.0;
  double flip_p99 = 0.0;
  double most = 0.0;  ///< largest difference
  std::uint64_t non_finite = 0;
};

/// The figures of `picture` against `reference`, with `map` its FLIP map. Throws like compare_images.
ErrorFigures error_figures(const Image& picture, const Image& reference, const FlipError& map);

/// Mean over pixels and channels of (a - ra)(b - rb) / (r^2 + 0.01), r the mean of `ra` and `rb`. For two independent
/// pictures of the same settings and two independent halves of the reference its expectation is the square of the bias
/// in the measure of relMSE: noise, which is independent, cancels, so it can fall below 0. Pixels with a value that is
/// not finite are left out. The halves' own noise has to be small: it is in the weight too. All images are
/// [height][width][4] of the same size.
double bias_product(const Image& a, const Image& b, const Image& ra, const Image& rb);

/// Mean of two images of the same size and channels.
Image mean_image(const Image& a, const Image& b);

}  // namespace vernier
