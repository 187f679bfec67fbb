#include "image/difference.h"

#include <cmath>

#include "image/check_pair.h"

namespace vernier {
namespace {

struct Sums {
  double squared = 0.0;
  double relative = 0.0;
  std::array<double, 3> signed_difference{};

  void add(const Sums& other) {
    squared += other.squared;
    relative += other.relative;
    for (std::size_t c = 0; c < 3; ++c) signed_difference[c] += other.signed_difference[c];
  }
};

bool finite(const std::array<double, 3>& rgb) {
  return std::isfinite(rgb[0]) && std::isfinite(rgb[1]) && std::isfinite(rgb[2]);
}

void add_pixel(Difference& result, Sums& sums, const std::array<double, 3>& a, const std::array<double, 3>& b, int x,
               int y) {
  for (int c = 0; c < 3; ++c) {
    const double difference = a[c] - b[c];
    sums.squared += difference * difference;
    sums.relative += difference * difference / (b[c] * b[c] + kRelMseFloor);
    sums.signed_difference[c] += difference;
    if (result.max_x >= 0 && !(std::fabs(difference) > result.max_absolute)) continue;
    result.max_absolute = std::fabs(difference);
    result.max_x = x;
    result.max_y = y;
    result.max_channel = c;
  }
}

Sums compare_row(Difference& result, const Image& a, const Image& b, int y) {
  Sums sums;
  for (int x = 0; x < a.width; ++x) {
    const std::size_t pixel = static_cast<std::size_t>(y) * a.width + x;
    const std::array<double, 3> rgb_a = rgb_of_pixel(a, pixel);
    const std::array<double, 3> rgb_b = rgb_of_pixel(b, pixel);
    const bool finite_a = finite(rgb_a);
    const bool finite_b = finite(rgb_b);
    result.non_finite_a += finite_a ? 0 : 1;
    result.non_finite_b += finite_b ? 0 : 1;
    if (!finite_a || !finite_b) continue;
    ++result.compared_pixels;
    add_pixel(result, sums, rgb_a, rgb_b, x, y);
  }
  return sums;
}

}  // namespace

Difference compare_images(const Image& a, const Image& b) {
  check_pair(a, b);
  Difference result;
  Sums sums;
  for (int y = 0; y < a.height; ++y) sums.add(compare_row(result, a, b, y));
  const double pixel_count = static_cast<double>(result.compared_pixels);
  result.rmse = std::sqrt(sums.squared / (3.0 * pixel_count));
  result.rel_mse = sums.relative / (3.0 * pixel_count);
  result.psnr_db = -20.0 * std::log10(result.rmse);
  for (std::size_t c = 0; c < 3; ++c) result.mean_signed[c] = sums.signed_difference[c] / pixel_count;
  result.finite = result.non_finite_a == 0 && result.non_finite_b == 0;
  return result;
}

}  // namespace vernier
