#include "accuracy/error_figures.h"

#include <cmath>

#include "image/difference.h"

namespace vernier {

ErrorFigures error_figures(const Image& picture, const Image& reference, const FlipError& map) {
  const Difference difference = compare_images(picture, reference);
  return {.rel_error = std::sqrt(difference.rel_mse),
          .rmse = difference.rmse,
          .rel_mse = difference.rel_mse,
          .psnr_db = difference.psnr_db,
          .flip_mean = map.mean,
          .flip_p99 = map.p99,
          .most = difference.max_absolute,
          .non_finite = difference.non_finite_a};
}

double bias_product(const Image& a, const Image& b, const Image& ra, const Image& rb) {
  double sum = 0.0;
  std::uint64_t count = 0;
  for (std::size_t i = 0; i < a.values.size(); ++i) {
    if (i % 4 == 3) continue;  // alpha
    const double mean = (static_cast<double>(ra.values[i]) + rb.values[i]) / 2.0;
    const double product = (static_cast<double>(a.values[i]) - ra.values[i]) *
                           (static_cast<double>(b.values[i]) - rb.values[i]) / (mean * mean + kRelMseFloor);
    if (!std::isfinite(product)) continue;
    sum += product;
    ++count;
  }
  return sum / static_cast<double>(count);
}

Image mean_image(const Image& a, const Image& b) {
  Image mean = a;
  for (std::size_t i = 0; i < mean.values.size(); ++i) mean.values[i] = (a.values[i] + b.values[i]) / 2.0f;
  return mean;
}

}  // namespace vernier
