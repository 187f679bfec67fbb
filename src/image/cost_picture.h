#pragma once

#include <vector>

#include "image/image.h"

namespace vernier {

/// What each pixel of the cost `layer` (channels rays, nodes, triangles) took: node visits plus triangle tests per
/// sample. On a device each of both is a step of the search, and about equally long.
std::vector<double> cost_steps(const Layer& layer);

/// The cost that 99 % of the `steps` do not pass, at least 1: a few pixels that took very long do not leave all others
/// black. Values that are not finite count as the largest. No steps: 1.
double cost_scale(std::vector<double> steps);

/// Heat map of the cost `layer` as display code values: [height][width][3] in [0, 1], from black at 0 over violet and
/// orange to pale yellow at cost_scale and above (error_color), so that a brighter pixel took longer, in grey too.
Image cost_picture(const Layer& layer, int width, int height);

}  // namespace vernier
