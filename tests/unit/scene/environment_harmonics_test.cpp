#include "scene/environment_harmonics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>

namespace vernier {
namespace {

constexpr double kPi = 3.14159265358979323846;

Scene image_scene(std::uint32_t width, std::uint32_t height,
                  const std::function<float(std::uint32_t x, std::uint32_t y)>& radiance) {
  Texels texels{TEXTURE_FORMAT_FLOAT, width, height, {}};
  for (std::uint32_t y = 0; y < height; ++y) {
    for (std::uint32_t x = 0; x < width; ++x) {
      for (int c = 0; c < 3; ++c) texels.words.push_back(std::bit_cast<std::uint32_t>(radiance(x, y)));
      texels.words.push_back(std::bit_cast<std::uint32_t>(1.0f));
    }
  }
  Scene scene;
  scene.textures.push_back({"", {}, std::make_shared<Texels>(std::move(texels))});
  scene.environment.texture = 0;
  return scene;
}

double mean_radiance(const std::array<glm::vec3, 9>& c, const glm::dvec3& n) {
  return c[0].r + c[1].r * n.y + c[2].r * n.z + c[3].r * n.x + c[4].r * n.x * n.y + c[5].r * n.y * n.z +
         c[6].r * (3.0 * n.z * n.z - 1.0) + c[7].r * n.x * n.z + c[8].r * (n.x * n.x - n.y * n.y);
}

TEST(AmbientHarmonics, GradientAndOverride) {
  Scene scene;
  scene.environment.sky = glm::vec3(0.9f, 0.6f, 0.3f);
  scene.environment.ground = glm::vec3(0.3f, 0.0f, 0.3f);
  // lerp(ground, sky, 1/2 + n.y / 3)
  EXPECT_NEAR(mean_radiance(ambient_harmonics(scene), {0, 1, 0}), 0.3 + 0.6 * (0.5 + 1.0 / 3.0), 1e-6);
  EXPECT_NEAR(mean_radiance(ambient_harmonics(scene), {0, -1, 0}), 0.3 + 0.6 * (0.5 - 1.0 / 3.0), 1e-6);
  scene.environment.has_ambient_override = true;
  scene.environment.ambient = glm::vec3(0.125f);
  EXPECT_EQ(mean_radiance(ambient_harmonics(scene), {0, 0, 1}), 0.125);
}

TEST(AmbientHarmonics, ConstantImageOfAnySizeIsExact) {
  for (const auto& [width, height] : {std::pair{1u, 1u}, {2u, 1u}, {5u, 3u}, {64u, 32u}}) {
    Scene scene = image_scene(width, height, [](auto, auto) { return 0.75f; });
    scene.environment.texture_scale = glm::vec3(2.0f);
    const std::array<glm::vec3, 9> c = ambient_harmonics(scene);
    EXPECT_FLOAT_EQ(c[0].r, 1.5f);
    for (std::size_t i = 1; i < 9; ++i) EXPECT_NEAR(c[i].r, 0.0f, 1e-7f);
  }
}

TEST(AmbientHarmonics, SmallLampShinesFromItsDirection) {
  // One bright texel near direction d of solid angle w: A(n) = radiance w (1/4 + dot/2 + 5/32 (3 dot^2 - 1)) / pi, the
  // cosine lobe to order 2 (dot = 1: 1.0625, against the true 1).
  const std::uint32_t width = 360;
  const std::uint32_t height = 180;
  for (const auto& [x, y] : {std::pair{180u, 90u}, {270u, 90u}, {20u, 10u}, {200u, 150u}, {100u, 60u}}) {
    const double phi = 2.0 * kPi * ((x + 0.5) / width - 0.5);
    const double theta = kPi * (y + 0.5) / height;
    const glm::dvec3 d(std::sin(theta) * std::sin(phi), std::cos(theta), -std::sin(theta) * std::cos(phi));
    const double solid_angle = 2.0 * kPi / width * (std::cos(kPi * y / height) - std::cos(kPi * (y + 1) / height));
    const auto lamp = [&](auto tx, auto ty) { return tx == x && ty == y ? 1000.0f : 0.0f; };
    const std::array<glm::vec3, 9> c = ambient_harmonics(image_scene(width, height, lamp));
    for (const glm::dvec3& n :
         {d, -d, glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1), glm::normalize(glm::dvec3(1, -2, 3))}) {
      const double dot = glm::dot(n, d);
      const double expected = 1000.0 * solid_angle / kPi * (0.25 + 0.5 * dot + 5.0 / 32.0 * (3.0 * dot * dot - 1.0));
      EXPECT_NEAR(mean_radiance(c, n), expected, 2e-4 * 1000.0 * solid_angle);
    }
  }
}

TEST(AmbientHarmonics, SmallImagesCountAsTheyAreLookedUp) {
  // One bright texel of 4 x 2, bilinear: over all directions the mean of its hat along u, 1/4, times that along v,
  // which is 1 above the middle of its row and falls to 0 at the middle of the other.
  constexpr int kSteps = 20000;
  double along_v = 0.0;
  for (int step = 0; step < kSteps; ++step) {
    const double v = (step + 0.5) / kSteps;
    along_v += std::clamp(2.0 * (0.75 - v), 0.0, 1.0) * std::sin(kPi * v) * kPi / (2.0 * kSteps);
  }
  const auto lamp = [](auto x, auto y) { return x == 1 && y == 0 ? 8.0f : 0.0f; };
  EXPECT_NEAR(ambient_harmonics(image_scene(4, 2, lamp))[0].r, 8.0 * 0.25 * along_v, 1e-5);
}

TEST(AmbientHarmonics, NonFiniteTexelsCountAsNothing) {
  const Scene scene = image_scene(2, 1, [](auto x, auto) { return x == 0 ? INFINITY : 1.0f; });
  EXPECT_FLOAT_EQ(ambient_harmonics(scene)[0].r, 0.5f);
}

}  // namespace
}  // namespace vernier
