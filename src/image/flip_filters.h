#pragma once

#include <vector>

#include "image/plane.h"

namespace vernier {

/// A two-dimensional filter as a sum of products: of weights across and down, the same for rows and columns.
using SeparableFilter = std::vector<Weights>;

/// Channels of YCxCz, whose contrast the eye resolves differently.
enum class Opponent { luminance, red_green, blue_yellow };

/// What the eye still resolves of `channel` at `pixels_per_degree`: the contrast sensitivity functions of the FLIP
/// paper (section 4.1.1, table 1) as a sum of Gaussians whose weights over all offsets add up to 1.
SeparableFilter contrast_filter(Opponent channel, double pixels_per_degree);

/// One-dimensional Gaussian, its first and its second derivative, with a feature width of 0.082 degrees (section 4.2).
struct FeatureWeights {
  Weights smooth;  ///< adds up to 1
  Weights edge;    ///< positive weights add up to 1, negative ones to -1
  Weights point;   ///< as `edge`
};

/// The weights that find edges and points at `pixels_per_degree`: derivative along one axis, `smooth` along the other.
FeatureWeights feature_weights(double pixels_per_degree);

}  // namespace vernier
