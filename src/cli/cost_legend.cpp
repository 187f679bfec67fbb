#include "cli/cost_legend.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <numeric>

#include "image/cost_picture.h"
#include "image/display_picture.h"

namespace vernier {

std::string cost_legend(const ImageFile& image) {
  for (const Layer& layer : image.layers) {
    if (layer_meaning(layer) != LayerMeaning::cost) continue;
    const std::vector<double> steps = cost_steps(layer);
    if (steps.empty()) continue;
    const double mean = std::accumulate(steps.begin(), steps.end(), 0.0) / static_cast<double>(steps.size());
    std::array<char, 200> text{};
    std::snprintf(text.data(), text.size(),
                  "cost: black 0 to pale yellow %.1f node visits and triangle tests per sample (99 %% of the pixels "
                  "are below), mean %.1f, largest %.1f",
                  cost_scale(steps), mean, *std::ranges::max_element(steps));
    return text.data();
  }
  return "";
}

}  // namespace vernier
