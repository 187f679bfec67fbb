#include "image/flip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>

#include "error.h"
#include "image/check_pair.h"
#include "image/flip_color.h"
#include "image/flip_filters.h"
#include "image/plane.h"

namespace vernier {
namespace {

using Planes = std::array<Plane, 3>;

// Finite colours after exposure in [0, 1]; anything else as a display image would show it.
Color3 displayed(const Color3& rgb, double gain) {
  Color3 shown{};
  for (std::size_t c = 0; c < 3; ++c) {
    if (!std::isfinite(rgb[c])) return {1.0, 0.0, 1.0};
    shown[c] = std::clamp(rgb[c] * gain, 0.0, 1.0);
  }
  return shown;
}

Planes opponent_planes(const Image& image, double gain) {
  const std::size_t pixel_count = static_cast<std::size_t>(image.width) * image.height;
  Planes planes;
  planes.fill(Plane{image.width, image.height, std::vector<float>(pixel_count)});
  for (std::size_t pixel = 0; pixel < pixel_count; ++pixel) {
    const Color3 ycxcz = ycxcz_from_linear(displayed(rgb_of_pixel(image, pixel), gain));
    for (std::size_t c = 0; c < 3; ++c) planes[c].values[pixel] = static_cast<float>(ycxcz[c]);
  }
  return planes;
}

Plane filtered(const Plane& plane, const SeparableFilter& filter) {
  Plane sum = filter_plane(plane, filter[0], filter[0]);
  for (std::size_t term = 1; term < filter.size(); ++term) {
    const Plane next = filter_plane(plane, filter[term], filter[term]);
    for (std::size_t i = 0; i < sum.values.size(); ++i) sum.values[i] += next.values[i];
  }
  return sum;
}

Planes seen_planes(const Planes& opponent, double pixels_per_degree) {
  constexpr std::array<Opponent, 3> kChannels = {Opponent::luminance, Opponent::red_green, Opponent::blue_yellow};
  Planes seen;
  for (std::size_t c = 0; c < 3; ++c) seen[c] = filtered(opponent[c], contrast_filter(kChannels[c], pixels_per_degree));
  return seen;
}

Color3 hunt_lab(const Planes& seen, std::size_t pixel) {
  Color3 linear = linear_from_ycxcz({seen[0].values[pixel], seen[1].values[pixel], seen[2].values[pixel]});
  for (double& value : linear) value = std::clamp(value, 0.0, 1.0);
  return hunt_lab_from_linear(linear);
}

// Section 4.1.3: exponent 0.7, then the lower 40 % of the range are stretched to 95 %. The largest distance is that of
// green and blue, the Rec.709 colours furthest apart.
double color_error(const Color3& lab_a, const Color3& lab_b) {
  constexpr double kExponent = 0.7;
  constexpr double kBend = 0.4;
  constexpr double kBentTo = 0.95;
  static const double largest =
      std::pow(hyab_distance(hunt_lab_from_linear({0.0, 1.0, 0.0}), hunt_lab_from_linear({0.0, 0.0, 1.0})), kExponent);
  const double distance = std::pow(hyab_distance(lab_a, lab_b), kExponent);
  const double bend = kBend * largest;
  if (distance < bend) return kBentTo / bend * distance;
  return kBentTo + (distance - bend) / (largest - bend) * (1.0 - kBentTo);
}

struct Features {
  Plane edge_x, edge_y, point_x, point_y;
};

Features find_features(const Plane& luminance, double pixels_per_degree) {
  Plane gray = luminance;
  for (float& value : gray.values) value = (value + 16.0f) / 116.0f;
  const FeatureWeights weights = feature_weights(pixels_per_degree);
  return {filter_plane(gray, weights.edge, weights.smooth), filter_plane(gray, weights.smooth, weights.edge),
          filter_plane(gray, weights.point, weights.smooth), filter_plane(gray, weights.smooth, weights.point)};
}

// Section 4.2: the larger of the differences in edge and point strength; sqrt(2) is the largest strength.
double feature_error(const Features& a, const Features& b, std::size_t pixel) {
  const auto strength = [pixel](const Plane& x, const Plane& y) {
    return std::hypot(x.values[pixel], y.values[pixel]);
  };
  const double edge = std::fabs(strength(a.edge_x, a.edge_y) - strength(b.edge_x, b.edge_y));
  const double point = std::fabs(strength(a.point_x, a.point_y) - strength(b.point_x, b.point_y));
  return std::clamp(std::sqrt(std::max(edge, point) / std::sqrt(2.0)), 0.0, 1.0);
}

double percentile_99(std::vector<float> values) {
  const std::size_t rank = (values.size() * 99 + 99) / 100;  // rounded up, counted from 1
  std::nth_element(values.begin(), values.begin() + (rank - 1), values.end());
  return values[rank - 1];
}

}  // namespace

FlipError flip(const Image& reference, const Image& test, float exposure_ev, double pixels_per_degree) {
  check_pair(reference, test);
  if (!(pixels_per_degree >= 1.0 && pixels_per_degree <= 10000.0))
    throw Error(ErrorKind::usage, "FLIP: pixels per degree must be from 1 to 10000");
  if (!(std::fabs(exposure_ev) <= 100.0f)) throw Error(ErrorKind::usage, "FLIP: the exposure must be within +-100 EV");
  const double gain = std::exp2(static_cast<double>(exposure_ev));
  const Planes opponent_a = opponent_planes(reference, gain);
  const Planes opponent_b = opponent_planes(test, gain);
  const Planes seen_a = seen_planes(opponent_a, pixels_per_degree);
  const Planes seen_b = seen_planes(opponent_b, pixels_per_degree);
  const Features features_a = find_features(opponent_a[0], pixels_per_degree);
  const Features features_b = find_features(opponent_b[0], pixels_per_degree);
  FlipError error{reference.width, reference.height, std::vector<float>(opponent_a[0].values.size()), 0.0, 0.0};
  for (std::size_t pixel = 0; pixel < error.map.size(); ++pixel) {
    const double color = color_error(hunt_lab(seen_a, pixel), hunt_lab(seen_b, pixel));
    // A feature that appears makes a colour difference more visible (section 4.3).
    const double value = std::pow(color, 1.0 - feature_error(features_a, features_b, pixel));
    error.map[pixel] = static_cast<float>(std::clamp(value, 0.0, 1.0));
    error.mean += error.map[pixel];
  }
  error.mean /= static_cast<double>(error.map.size());
  error.p99 = percentile_99(error.map);
  return error;
}

}  // namespace vernier
