#pragma once

#include <array>
#include <vector>

#include "image/image.h"

namespace vernier {

/// Colour that shows an error of `value`: linear Rec.709, from black at 0 over violet and orange to pale yellow at 1,
/// brighter for larger values. Values outside [0, 1] count as the nearest end, NaN is magenta, which the ramp lacks.
std::array<float, 3> error_color(float value);

/// Picture of the error map `errors` ([height][width], as FlipError::map): [height][width][3] linear Rec.709, each
/// pixel its error_color. Written as a display image without exposure it shows the ramp's own sRGB colours.
/// Throws Error(usage) unless there are width x height errors.
Image error_picture(const std::vector<float>& errors, int width, int height);

}  // namespace vernier
