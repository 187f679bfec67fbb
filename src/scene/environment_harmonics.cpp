#include "scene/environment_harmonics.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "scene/texel_color.h"

namespace vernier {
namespace {

using std::numbers::pi;
using Coefficients = std::array<glm::dvec3, 9>;

// Squared norm factors of the real spherical harmonics, times the factors 1, 2/3, 1/4 of the cosine lobe over pi.
constexpr std::array<double, 9> kFolded = {1.0 / (4.0 * pi),  // 1
                                           (2.0 / 3.0) * 3.0 / (4.0 * pi),
                                           (2.0 / 3.0) * 3.0 / (4.0 * pi),
                                           (2.0 / 3.0) * 3.0 / (4.0 * pi),  // y z x
                                           0.25 * 15.0 / (4.0 * pi),
                                           0.25 * 15.0 / (4.0 * pi),  // xy yz
                                           0.25 * 5.0 / (16.0 * pi),  // 3z^2 - 1
                                           0.25 * 15.0 / (4.0 * pi),
                                           0.25 * 15.0 / (16.0 * pi)};  // xz x^2 - y^2

using Integrals = std::array<double, 6>;

// Over one of `count` columns, phi = atan2(x, -z), x = sin(theta) sin(phi), z = -sin(theta) cos(phi): of 1, sin, cos,
// sin cos, sin^2, cos^2.
Integrals column_integrals(std::uint32_t column, std::uint32_t count) {
  const double a = 2.0 * pi * (column / double(count) - 0.5);
  const double b = 2.0 * pi * ((column + 1) / double(count) - 0.5);
  const double twice = 0.25 * (std::sin(2.0 * b) - std::sin(2.0 * a));
  return {b - a,
          std::cos(a) - std::cos(b),
          std::sin(b) - std::sin(a),
          0.25 * (std::cos(2.0 * a) - std::cos(2.0 * b)),
          0.5 * (b - a) - twice,
          0.5 * (b - a) + twice};
}

// Over one of `count` rows, with the sin(theta) of the solid angle: of 1, y, y^2, sin, sin y, sin^2.
Integrals row_integrals(std::uint32_t row, std::uint32_t count) {
  const double a = pi * row / double(count);
  const double b = pi * (row + 1) / double(count);
  const auto powers = [](double angle) { return glm::dvec2(std::cos(angle), std::sin(angle)); };
  const glm::dvec2 from = powers(a);
  const glm::dvec2 to = powers(b);
  const double one = from.x - to.x;
  const double yy = (from.x * from.x * from.x - to.x * to.x * to.x) / 3.0;
  return {one,
          0.5 * (to.y * to.y - from.y * from.y),
          yy,
          0.5 * (b - a) - 0.25 * (std::sin(2.0 * b) - std::sin(2.0 * a)),
          (to.y * to.y * to.y - from.y * from.y * from.y) / 3.0,
          one - yy};
}

// The integrals of each of `count` texels along an axis, weighed as the bilinear look-up weighs it: by a hat that
// reaches to the middle of its neighbours. The hat is a step for each of some cells, which add up to 1.
template <typename CellIntegrals>
std::vector<Integrals> hat_integrals(std::uint32_t count, bool repeats, const CellIntegrals& of_cell) {
  // A step for a slope is off by the second order of its width: (2 pi / 1024)^2 / 12, 3e-6 of the basis's slope.
  constexpr std::uint32_t kLeastCells = 1024;
  const std::uint32_t half = std::max((kLeastCells + 2 * count - 1) / (2 * count), 1u);  // cells of half a texel
  const std::uint32_t cells = 2 * half * count;
  std::vector<Integrals> sums(count, Integrals{});
  for (std::uint32_t cell = 0; cell < cells; ++cell) {
    const Integrals part = of_cell(cell, cells);
    const double place = (cell + 0.5) / (2.0 * half) + 0.5;  // 1 in the middle of texel 0
    const auto upper = static_cast<std::uint32_t>(place);
    const double share = place - upper;
    const std::uint32_t before = upper == 0 ? (repeats ? count - 1 : 0) : upper - 1;
    const std::uint32_t after = upper == count ? (repeats ? 0 : count - 1) : upper;
    for (std::size_t i = 0; i < part.size(); ++i) {
      sums[before][i] += (1.0 - share) * part[i];
      sums[after][i] += share * part[i];
    }
  }
  return sums;
}

// The basis of the header, integrated over one texel.
std::array<double, 9> texel_integrals(const Integrals& row, const Integrals& column) {
  const auto& [row_one, y, yy, s, sy, ss] = row;
  const auto& [column_one, sin, cos, sin_cos, sin_sin, cos_cos] = column;
  const double one = row_one * column_one;
  return {one,
          y * column_one,
          -s * cos,
          s * sin,
          sy * sin,
          -sy * cos,
          3.0 * ss * cos_cos - one,
          -ss * sin_cos,
          ss * sin_sin - yy * column_one};
}

glm::dvec3 finite_color(const Texels& texels, std::size_t index) {
  glm::dvec3 color(texel_color(texels, index));
  for (int c = 0; c < 3; ++c) {
    if (!std::isfinite(color[c])) color[c] = 0.0;
  }
  return color;
}

Coefficients image_coefficients(const Texels& texels) {
  const std::vector<Integrals> columns = hat_integrals(texels.width, true, column_integrals);
  const std::vector<Integrals> rows = hat_integrals(texels.height, false, row_integrals);
  Coefficients sums{};
  for (std::uint32_t y = 0; y < texels.height; ++y) {
    for (std::uint32_t x = 0; x < texels.width; ++x) {
      const glm::dvec3 color = finite_color(texels, std::size_t{y} * texels.width + x);
      const std::array<double, 9> weights = texel_integrals(rows[y], columns[x]);
      for (std::size_t i = 0; i < 9; ++i) sums[i] += weights[i] * color;
    }
  }
  for (std::size_t i = 0; i < 9; ++i) sums[i] *= kFolded[i];
  return sums;
}

}  // namespace

std::array<glm::vec3, 9> ambient_harmonics(const Scene& scene) {
  const Environment& environment = scene.environment;
  std::array<glm::vec3, 9> result{};
  if (environment.has_ambient_override) {
    result[0] = environment.ambient;
  } else if (environment.texture >= 0) {
    const Texture& texture = scene.textures[static_cast<std::size_t>(environment.texture)];
    const Coefficients coefficients = image_coefficients(*texture.texels);
    for (std::size_t i = 0; i < 9; ++i) result[i] = glm::vec3(coefficients[i] * glm::dvec3(environment.texture_scale));
  } else {
    // Radiance (ground + sky) / 2 + y (sky - ground) / 2, of which the lobe keeps 1 and 2/3.
    result[0] = 0.5f * (environment.ground + environment.sky);
    result[1] = (environment.sky - environment.ground) / 3.0f;
  }
  return result;
}

}  // namespace vernier
