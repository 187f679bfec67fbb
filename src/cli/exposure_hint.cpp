#include "cli/exposure_hint.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

namespace vernier {
namespace {

// Largest channel of each pixel of the colour layer; empty without one.
std::vector<float> brightness(const ImageFile& image) {
  std::vector<float> values;
  for (const Layer& layer : image.layers) {
    const auto* color = std::get_if<std::vector<float>>(&layer.values);
    const std::size_t channel_count = layer.channels.size();
    if (!layer.name.empty() || !color || channel_count < 3) {
      continue;
    }
    for (std::size_t first = 0; first + channel_count <= color->size(); first += channel_count) {
      const float value = std::max({(*color)[first], (*color)[first + 1], (*color)[first + 2]});
      values.push_back(std::isfinite(value) ? value : 0.0f);
    }
  }
  return values;
}

}  // namespace

std::string exposure_hint(const ImageFile& image, float exposure_ev) {
  std::vector<float> values = brightness(image);
  if (values.empty()) {
    return "";
  }
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  const double median = *middle;
  if (!(median * std::exp2(exposure_ev) > 1.0)) {
    return "";
  }
  constexpr double kStepsPerStop = 2.0;
  const double stops = std::floor(-std::log2(median) * kStepsPerStop) / kStepsPerStop;
  char text[96];
  std::snprintf(text, sizeof text, "hint: more than half of the image is brighter than white; try --exposure %g",
                stops);
  return text;
}

}  // namespace vernier
