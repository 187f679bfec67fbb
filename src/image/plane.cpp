#include "image/plane.h"

#include <algorithm>
#include <cstddef>

namespace vernier {
namespace {

void add_weighted(float* sum, const float* values, double weight, int count) {
  const float factor = static_cast<float>(weight);
  for (int i = 0; i < count; ++i) sum[i] += factor * values[i];
}

Plane filter_across(const Plane& plane, const Weights& weights) {
  const int radius = static_cast<int>(weights.size() / 2);
  Plane result{plane.width, plane.height, std::vector<float>(plane.values.size(), 0.0f)};
  std::vector<float> padded(plane.width + 2 * static_cast<std::size_t>(radius));
  for (int y = 0; y < plane.height; ++y) {
    const float* row = plane.values.data() + static_cast<std::size_t>(y) * plane.width;
    std::fill_n(padded.begin(), radius, row[0]);
    std::copy_n(row, plane.width, padded.begin() + radius);
    std::fill_n(padded.begin() + radius + plane.width, radius, row[plane.width - 1]);
    float* sum = result.values.data() + static_cast<std::size_t>(y) * plane.width;
    for (std::size_t i = 0; i < weights.size(); ++i) add_weighted(sum, padded.data() + i, weights[i], plane.width);
  }
  return result;
}

Plane filter_down(const Plane& plane, const Weights& weights) {
  const int radius = static_cast<int>(weights.size() / 2);
  Plane result{plane.width, plane.height, std::vector<float>(plane.values.size(), 0.0f)};
  for (int y = 0; y < plane.height; ++y) {
    float* sum = result.values.data() + static_cast<std::size_t>(y) * plane.width;
    for (int offset = -radius; offset <= radius; ++offset) {
      const int row = std::clamp(y + offset, 0, plane.height - 1);
      add_weighted(sum, plane.values.data() + static_cast<std::size_t>(row) * plane.width, weights[offset + radius],
                   plane.width);
    }
  }
  return result;
}

}  // namespace

Plane filter_plane(const Plane& plane, const Weights& across, const Weights& down) {
  if (plane.values.empty()) return plane;
  return filter_down(filter_across(plane, across), down);
}

}  // namespace vernier
