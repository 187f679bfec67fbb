#include "image/flip_color.h"

#include <cmath>

namespace vernier {
namespace {

// Linear Rec.709 to XYZ for the white point D65 at chromaticity (0.3127, 0.3290), as exact fractions: primaries
// (0.64, 0.33), (0.30, 0.60), (0.15, 0.06) scaled so that (1, 1, 1) has that white and Y = 1.
constexpr double kXyzFromLinear[3][3] = {{10135552.0 / 24577794.0, 8788810.0 / 24577794.0, 4435075.0 / 24577794.0},
                                         {2613072.0 / 12288897.0, 8788810.0 / 12288897.0, 887015.0 / 12288897.0},
                                         {1425312.0 / 73733382.0, 8788810.0 / 73733382.0, 70074185.0 / 73733382.0}};

double row_sum(int row) {
  return kXyzFromLinear[row][0] + kXyzFromLinear[row][1] + kXyzFromLinear[row][2];
}

// XYZ divided by that of white (1, 1, 1).
Color3 relative_xyz(const Color3& linear) {
  Color3 xyz{};
  for (int row = 0; row < 3; ++row) {
    for (int c = 0; c < 3; ++c) xyz[row] += kXyzFromLinear[row][c] * linear[c];
    xyz[row] /= row_sum(row);
  }
  return xyz;
}

struct Matrix3 {
  double m[3][3];
};

// Inverse of kXyzFromLinear by cofactors.
Matrix3 linear_from_xyz_matrix() {
  const auto& m = kXyzFromLinear;
  const auto cofactor = [&m](int row, int column) {
    const int r1 = (row + 1) % 3, r2 = (row + 2) % 3, c1 = (column + 1) % 3, c2 = (column + 2) % 3;
    return m[r1][c1] * m[r2][c2] - m[r1][c2] * m[r2][c1];
  };
  const double determinant = m[0][0] * cofactor(0, 0) + m[0][1] * cofactor(0, 1) + m[0][2] * cofactor(0, 2);
  Matrix3 inverse{};
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) inverse.m[row][column] = cofactor(column, row) / determinant;
  return inverse;
}

// Cube root with the linear part near black that CIELab prescribes (CIE 15:2004).
double lab_curve(double t) {
  constexpr double kDelta = 6.0 / 29.0;
  return t > kDelta * kDelta * kDelta ? std::cbrt(t) : t / (3.0 * kDelta * kDelta) + 4.0 / 29.0;
}

}  // namespace

Color3 ycxcz_from_linear(const Color3& linear) {
  const Color3 xyz = relative_xyz(linear);
  return {116.0 * xyz[1] - 16.0, 500.0 * (xyz[0] - xyz[1]), 200.0 * (xyz[1] - xyz[2])};
}

Color3 linear_from_ycxcz(const Color3& ycxcz) {
  static const Matrix3 inverse = linear_from_xyz_matrix();
  const double y = (ycxcz[0] + 16.0) / 116.0;
  const Color3 xyz = {(y + ycxcz[1] / 500.0) * row_sum(0), y * row_sum(1), (y - ycxcz[2] / 200.0) * row_sum(2)};
  Color3 linear{};
  for (int row = 0; row < 3; ++row)
    for (int c = 0; c < 3; ++c) linear[row] += inverse.m[row][c] * xyz[c];
  return linear;
}

Color3 hunt_lab_from_linear(const Color3& linear) {
  const Color3 xyz = relative_xyz(linear);
  const double x = lab_curve(xyz[0]), y = lab_curve(xyz[1]), z = lab_curve(xyz[2]);
  const double lightness = 116.0 * y - 16.0;
  const double weight = 0.01 * lightness;
  return {lightness, weight * 500.0 * (x - y), weight * 200.0 * (y - z)};
}

double hyab_distance(const Color3& lab_a, const Color3& lab_b) {
  return std::fabs(lab_a[0] - lab_b[0]) + std::hypot(lab_a[1] - lab_b[1], lab_a[2] - lab_b[2]);
}

}  // namespace vernier
