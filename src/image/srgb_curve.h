#pragma once

namespace vernier {

/// sRGB code value of the linear value `linear`, the exact piecewise curve of IEC 61966-2-1: [0, 1] to [0, 1].
/// Not clamped; values below the linear part's end, negative ones too, follow the linear part. NaN gives NaN.
double srgb_from_linear(double linear);

/// Linear value of the sRGB code value `code`, the inverse of srgb_from_linear to within its rounded constants
/// (4e-8 where the two parts meet). Not clamped; NaN gives NaN.
double linear_from_srgb(double code);

}  // namespace vernier
