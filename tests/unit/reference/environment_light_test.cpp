#include "reference/environment_light.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <functional>
#include <numbers>

#include "test_scenes.h"

namespace vernier::reference {
namespace {

constexpr double kPi = std::numbers::pi;

void expect_near(const glm::dvec3& a, const glm::dvec3& b, double bound) {
  EXPECT_LT(glm::distance(a, b), bound) << a.x << ' ' << a.y << ' ' << a.z;
}

// An image environment whose texel centres have the red radiance(direction), green half of it.
Scene image_scene(std::uint32_t width, std::uint32_t height, const std::function<double(glm::dvec3)>& radiance) {
  Texels texels{TEXTURE_FORMAT_FLOAT, width, height, {}};
  for (std::uint32_t y = 0; y < height; ++y) {
    for (std::uint32_t x = 0; x < width; ++x) {
      const double azimuth = 2.0 * kPi * ((x + 0.5) / width - 0.5);
      const double polar = kPi * (y + 0.5) / height;
      const double value =
          radiance({std::sin(polar) * std::sin(azimuth), std::cos(polar), -std::sin(polar) * std::cos(azimuth)});
      for (const double channel : {value, value / 2.0, 0.0, 1.0})
        texels.words.push_back(std::bit_cast<std::uint32_t>(static_cast<float>(channel)));
    }
  }
  Scene scene;
  scene.environment.texture = test::add_texture(scene, std::make_shared<Texels>(texels));
  return scene;
}

TEST(EnvironmentRadiance, GradientIsLinearInHeight) {
  Scene scene;
  scene.environment.sky = {1.0f, 2.0f, 4.0f};
  scene.environment.ground = {0.0f, 1.0f, 0.0f};
  expect_near(environment_radiance(scene, {0, 1, 0}), {1, 2, 4}, 1e-15);
  expect_near(environment_radiance(scene, {0, -1, 0}), {0, 1, 0}, 1e-15);
  expect_near(environment_radiance(scene, {0.8, 0.6, 0}), {0.8, 1.8, 3.2}, 1e-15);
}

// A 4 x 2 image: the columns' centres look to (-X, +Z), (-X, -Z), (+X, -Z), (+X, +Z); the upper row is up.
TEST(EnvironmentRadiance, ImageOrientation) {
  Scene scene;
  const auto texels = test::linear_texels(4, 2, {0x01u, 0x02u, 0x03u, 0x04u, 0x05u, 0x06u, 0x07u, 0x08u});
  scene.environment.texture =
      test::add_texture(scene, texels, {TEXTURE_WRAP_CLAMP, TEXTURE_WRAP_REPEAT, TEXTURE_FILTER_NEAREST});
  scene.environment.texture_scale = glm::vec3(255.0f);
  const double h = std::sqrt(0.5);  // half way up: the centre of a row
  const auto red = [&](double x, double y, double z) { return environment_radiance(scene, {x, y, z}).x; };
  EXPECT_NEAR(red(-0.5, h, 0.5), 1.0, 1e-12);
  EXPECT_NEAR(red(-0.5, h, -0.5), 2.0, 1e-12);
  EXPECT_NEAR(red(0.5, h, -0.5), 3.0, 1e-12);
  EXPECT_NEAR(red(0.5, -h, 0.5), 8.0, 1e-12);
  EXPECT_NEAR(red(0.0, h, -h), 2.5, 1e-12);  // between columns, though the sampler says nearest
  EXPECT_NEAR(red(0.0, h, h), 2.5, 1e-12);   // around the seam: 4 and 1, though the sampler says clamp
}

TEST(EnvironmentRadiance, PolesAreClampedAndFinite) {
  const Scene scene = image_scene(8, 4, [](glm::dvec3 d) { return d.y > 0.8 ? 2.0 : 1.0; });
  EXPECT_NEAR(environment_radiance(scene, {0, 1, 0}).x, 2.0, 1e-12);
  EXPECT_NEAR(environment_radiance(scene, {0, -1, 0}).x, 1.0, 1e-12);
}

TEST(AmbientRadiance, OverrideIsTheSameEverywhere) {
  Scene scene;
  scene.environment.sky = glm::vec3(9.0f);
  scene.environment.has_ambient_override = true;
  scene.environment.ambient = {0.25f, 0.5f, 1.0f};
  expect_near(ambient_radiance(prepare_environment(scene), {0, 0, 1}), {0.25, 0.5, 1.0}, 1e-15);
}

// The cosine-weighted mean, by midpoints over the hemisphere, against the closed form for a gradient.
TEST(AmbientRadiance, GradientIsTheCosineWeightedMean) {
  Scene scene;
  scene.environment.sky = glm::vec3(3.0f, 1.0f, 0.0f);
  scene.environment.ground = glm::vec3(0.5f, 1.0f, 2.0f);
  const glm::dvec3 normal(0.48, 0.64, 0.6);
  const glm::dvec3 tangent = glm::normalize(glm::cross(normal, glm::dvec3(1, 0, 0)));
  const glm::dvec3 bitangent = glm::cross(normal, tangent);
  glm::dvec3 mean(0.0);
  const int steps = 200;
  for (int i = 0; i < steps; ++i) {
    for (int j = 0; j < steps; ++j) {
      const double radius = std::sqrt((i + 0.5) / steps);  // uniform on the disc is cosine-weighted above it
      const double angle = 2.0 * kPi * (j + 0.5) / steps;
      mean += environment_radiance(scene, radius * std::cos(angle) * tangent + radius * std::sin(angle) * bitangent +
                                              std::sqrt(1.0 - radius * radius) * normal);
    }
  }
  expect_near(ambient_radiance(prepare_environment(scene), normal), mean / (1.0 * steps * steps), 1e-4);
}

TEST(AmbientRadiance, UniformImageGivesItsRadiance) {
  const Scene scene = image_scene(4, 2, [](glm::dvec3) { return 3.0; });
  const EnvironmentLight light = prepare_environment(scene);
  for (const glm::dvec3& normal : {glm::dvec3(0, 1, 0), glm::dvec3(0.6, 0, -0.8)})
    expect_near(ambient_radiance(light, normal), {3.0, 1.5, 0.0}, 1e-5);
}

// Around n the mean of d.a is (2/3) n.a, that of (d.a)^2 is 1/4 + (n.a)^2 / 4.
TEST(AmbientRadiance, ImageOfLowDegreeIsExact) {
  const glm::dvec3 axis = glm::normalize(glm::dvec3(1, 2, -2));
  const Scene scene = image_scene(512, 256, [&](glm::dvec3 d) {
    const double along = glm::dot(d, axis);
    return 2.0 + along + along * along;
  });
  const EnvironmentLight light = prepare_environment(scene);
  for (const glm::dvec3& normal :
       {glm::dvec3(0, 1, 0), glm::dvec3(1, 0, 0), glm::dvec3(0, 0, 1), glm::dvec3(0.48, -0.64, 0.6)}) {
    const double along = glm::dot(normal, axis);
    const double expected = 2.0 + 2.0 / 3.0 * along + 0.25 + 0.25 * along * along;
    EXPECT_NEAR(ambient_radiance(light, normal).x, expected,
                2e-4);  // the bilinear filter flattens peaks by (pi / 256)^2
  }
}

TEST(AmbientRadiance, IsNeverNegative) {
  const Scene scene = image_scene(64, 32, [](glm::dvec3 d) { return d.y > 0.95 ? 100.0 : 0.0; });
  const EnvironmentLight light = prepare_environment(scene);
  for (double y = -1.0; y <= 1.0; y += 0.125)
    EXPECT_GE(ambient_radiance(light, {std::sqrt(1.0 - y * y), y, 0.0}).x, 0.0);
  EXPECT_EQ(ambient_radiance(light, glm::normalize(glm::dvec3(1.0, -0.3, 0.0))).x, 0.0);
}

}  // namespace
}  // namespace vernier::reference
