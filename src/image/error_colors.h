#pragma once

#include <array>

namespace vernier {

/// Colour that shows an error of `value`: linear Rec.709, from black at 0 over violet and orange to pale yellow at 1,
/// brighter for larger values. Values outside [0, 1] count as the nearest end, NaN is magenta, which the ramp lacks.
std::array<float, 3> error_color(float value);

}  // namespace vernier
