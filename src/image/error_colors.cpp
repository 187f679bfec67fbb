#include "image/error_colors.h"

#include <algorithm>
#include <cmath>

#include "image/srgb_curve.h"

namespace vernier {
namespace {

constexpr std::size_t kStopCount = 9;

// sRGB code values at equal steps of the error, in the manner of matplotlib's magma: lightness rises steadily, so that
// the picture reads the same in grey.
constexpr std::array<std::array<double, 3>, kStopCount> kStops = {{{0.00, 0.00, 0.02},
                                                                   {0.10, 0.06, 0.26},
                                                                   {0.31, 0.07, 0.48},
                                                                   {0.50, 0.15, 0.50},
                                                                   {0.71, 0.21, 0.48},
                                                                   {0.90, 0.31, 0.39},
                                                                   {0.98, 0.53, 0.38},
                                                                   {1.00, 0.76, 0.53},
                                                                   {0.99, 0.99, 0.75}}};

}  // namespace

std::array<float, 3> error_color(float value) {
  if (std::isnan(value)) return {1.0f, 0.0f, 1.0f};
  const double position = std::clamp(static_cast<double>(value), 0.0, 1.0) * (kStopCount - 1);
  const std::size_t stop = std::min(static_cast<std::size_t>(position), kStopCount - 2);
  const double part = position - static_cast<double>(stop);
  std::array<float, 3> color{};
  for (std::size_t c = 0; c < 3; ++c)
    color[c] = static_cast<float>(linear_from_srgb(std::lerp(kStops[stop][c], kStops[stop + 1][c], part)));
  return color;
}

}  // namespace vernier
