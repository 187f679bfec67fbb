#include "image/cost_picture.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "image/error_colors.h"
#include "image/srgb_curve.h"

namespace vernier {

std::vector<double> cost_steps(const Layer& layer) {
  const std::size_t width = layer.channels.size();
  const auto channel = [&](const char* name) {
    return static_cast<std::size_t>(std::ranges::find(layer.channels, name) - layer.channels.begin());
  };
  const std::size_t nodes = channel("nodes");
  const std::size_t triangles = channel("triangles");
  return std::visit(
      [&](const auto& values) {
        std::vector<double> steps;
        steps.reserve(values.size() / width);
        for (std::size_t first = 0; first + width <= values.size(); first += width)
          steps.push_back(static_cast<double>(values[first + nodes]) + static_cast<double>(values[first + triangles]));
        return steps;
      },
      layer.values);
}

double cost_scale(std::vector<double> steps) {
  if (steps.empty()) return 1.0;
  for (double& step : steps)
    if (!std::isfinite(step)) step = std::numeric_limits<double>::max();
  const std::size_t rank = (steps.size() - 1) * 99 / 100;
  std::ranges::nth_element(steps, steps.begin() + static_cast<std::ptrdiff_t>(rank));
  return std::max(steps[rank], 1.0);
}

Image cost_picture(const Layer& layer, int width, int height) {
  const std::vector<double> steps = cost_steps(layer);
  const double scale = cost_scale(steps);
  Image picture{width, height, 3, {}};
  picture.values.reserve(steps.size() * 3);
  for (const double step : steps)
    for (const float value : error_color(static_cast<float>(step / scale)))
      picture.values.push_back(static_cast<float>(srgb_from_linear(value)));
  return picture;
}

}  // namespace vernier
