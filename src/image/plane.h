#pragma once

#include <vector>

namespace vernier {

/// One value per pixel: [height][width], row 0 on top.
struct Plane {
  int width = 0;
  int height = 0;
  std::vector<float> values;
};

/// Weights of a one-dimensional filter at the offsets -radius ... radius; 2 radius + 1 of them.
using Weights = std::vector<double>;

/// `plane` weighed by `across` along rows, then by `down` along columns (correlation: the weight at offset d meets the
/// pixel d to the right or below). Beyond the border the nearest pixel counts. Sizes stay; an empty plane stays empty.
/// Both filters have an odd number of weights. NaN spreads as far as the filters reach.
Plane filter_plane(const Plane& plane, const Weights& across, const Weights& down);

}  // namespace vernier
