#pragma once

#include <array>

namespace vernier {

/// Three coordinates of one colour.
using Color3 = std::array<double, 3>;

/// Linear Rec.709 to YCxCz, the linearised CIELab in which contrast sensitivity is separable (Flohr et al. 1993,
/// Lossy compression of color images). White (1, 1, 1) is (100, 0, 0).
Color3 ycxcz_from_linear(const Color3& linear);

/// The inverse of ycxcz_from_linear; the result may lie outside [0, 1].
Color3 linear_from_ycxcz(const Color3& ycxcz);

/// Linear Rec.709 in [0, 1] to CIELab relative to white (1, 1, 1), with a and b weighed by 0.01 L: colours seem more
/// colourful when they are brighter (Hunt 1952).
Color3 hunt_lab_from_linear(const Color3& linear);

/// Distance |dL| + sqrt(da^2 + db^2), made for large differences (Abasi et al. 2020, Distance metrics for very large
/// color differences).
double hyab_distance(const Color3& lab_a, const Color3& lab_b);

}  // namespace vernier
