#include "reference/environment_light.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "reference/textures.h"

namespace vernier::reference {

namespace {

constexpr double kPi = std::numbers::pi;

// Real spherical harmonics, orthonormal over the sphere: l = 0; l = 1, m = -1..1; l = 2, m = -2..2.
std::array<double, 9> harmonics_of(const glm::dvec3& d) {
  const double band0 = std::sqrt(1.0 / (4.0 * kPi));
  const double band1 = std::sqrt(3.0 / (4.0 * kPi));
  const double band2 = std::sqrt(15.0 / (4.0 * kPi));
  return {band0,
          band1 * d.y,
          band1 * d.z,
          band1 * d.x,
          band2 * d.x * d.y,
          band2 * d.y * d.z,
          band2 * (3.0 * d.z * d.z - 1.0) / std::sqrt(12.0),
          band2 * d.x * d.z,
          band2 * (d.x * d.x - d.y * d.y) / 2.0};
}

glm::dvec3 image_radiance(const Scene& scene, glm::dvec2 uv) {
  const Sampler sampler{TEXTURE_WRAP_REPEAT, TEXTURE_WRAP_CLAMP, TEXTURE_FILTER_LINEAR};
  const Texture& texture = scene.textures[scene.environment.texture];
  return glm::dvec3(scene.environment.texture_scale) * glm::dvec3(sample_texels(*texture.texels, sampler, uv));
}

// An even number per texel puts the texel centres, where the bilinear filter has its kinks, between cells.
std::uint32_t cells(std::uint32_t texel_count, std::uint32_t at_least) {
  const std::uint32_t pairs = (at_least + 2 * texel_count - 1) / (2 * texel_count);
  return 2 * pairs * texel_count;
}

std::array<glm::dvec3, 9> integrate_image(const Scene& scene) {
  const Texels& texels = *scene.textures[scene.environment.texture].texels;
  const std::uint32_t columns = cells(texels.width, 1024);
  const std::uint32_t rows = cells(texels.height, 512);
  std::array<glm::dvec3, 9> sums{};
  for (std::uint32_t row = 0; row < rows; ++row) {
    const double v = (row + 0.5) / rows;
    const double sine = std::sin(kPi * v);
    for (std::uint32_t column = 0; column < columns; ++column) {
      const double u = (column + 0.5) / columns;
      const double azimuth = 2.0 * kPi * (u - 0.5);
      const glm::dvec3 direction(sine * std::sin(azimuth), std::cos(kPi * v), -sine * std::cos(azimuth));
      const glm::dvec3 radiance = sine * image_radiance(scene, {u, v});
      const std::array<double, 9> basis = harmonics_of(direction);
      for (int i = 0; i < 9; ++i) sums[i] += basis[i] * radiance;
    }
  }
  // The exact solid angle of a cell over the sine of its middle, so that a uniform image comes out exactly.
  const double solid_angle = 2.0 * kPi / columns * 2.0 * std::sin(kPi / (2.0 * rows));
  for (glm::dvec3& sum : sums) sum *= solid_angle;
  return sums;
}

}  // namespace

EnvironmentLight prepare_environment(const Scene& scene) {
  EnvironmentLight light{&scene, {}};
  if (scene.environment.texture >= 0 && !scene.environment.has_ambient_override)
    light.harmonics = integrate_image(scene);
  return light;
}

glm::dvec3 environment_radiance(const Scene& scene, const glm::dvec3& direction) {
  const Environment& environment = scene.environment;
  if (environment.texture >= 0) {
    const double u = 0.5 + std::atan2(direction.x, -direction.z) / (2.0 * kPi);
    return image_radiance(scene, {u, std::acos(std::clamp(direction.y, -1.0, 1.0)) / kPi});
  }
  return glm::mix(glm::dvec3(environment.ground), glm::dvec3(environment.sky), 0.5 + 0.5 * direction.y);
}

glm::dvec3 ambient_radiance(const EnvironmentLight& light, const glm::dvec3& normal) {
  const Environment& environment = light.scene->environment;
  if (environment.has_ambient_override) return glm::dvec3(environment.ambient);
  if (environment.texture < 0)
    return glm::mix(glm::dvec3(environment.ground), glm::dvec3(environment.sky), 0.5 + normal.y / 3.0);
  // Ramamoorthi and Hanrahan 2001: the clamped cosine scales the bands by pi, 2 pi / 3 and pi / 4; the mean is over pi.
  const std::array<double, 9> basis = harmonics_of(normal);
  glm::dvec3 sum = basis[0] * light.harmonics[0];
  for (int i = 1; i < 4; ++i) sum += 2.0 / 3.0 * basis[i] * light.harmonics[i];
  for (int i = 4; i < 9; ++i) sum += 0.25 * basis[i] * light.harmonics[i];
  return glm::max(sum, glm::dvec3(0.0));
}

}  // namespace vernier::reference
