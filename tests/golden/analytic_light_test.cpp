#include <cmath>

#include "analytic_scene.h"

namespace vernier::golden {
namespace {

constexpr double kPi = 3.14159265358979323846;
// About 40 roundings of 2^-24 from the camera to the film.
constexpr double kRelative = 0x1p-18;

class PlaneUnderALamp : public AnalyticScene {};

// L = kd / pi I cos(theta) / d^2, by hand for every pixel.
TEST_F(PlaneUnderALamp, IsAsBrightAsTheClosedForm) {
  constexpr int kSize = 33;
  const glm::dvec3 lamp(0.5, 0.25, 1.5);
  const glm::dvec3 intensity(3.0, 5.0, 7.0), diffuse(0.75, 0.5, 0.25);
  add_rectangle(scene_, {-8, -8, 0}, {16, 0, 0}, {0, 16, 0}, matte(glm::vec3(diffuse)));
  Light light;
  light.position = lamp;
  light.intensity = glm::vec3(intensity);
  scene_.lights.push_back(light);
  look_from({0, 0, 2}, kPi / 2.0);
  RenderSettings settings;
  settings.width = settings.height = kSize;
  const std::vector<float> colors = render(settings);
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      const glm::dvec3 point(2.0 * (2.0 * (x + 0.5) / kSize - 1.0), 2.0 * (1.0 - 2.0 * (y + 0.5) / kSize), 0.0);
      const glm::dvec3 way = lamp - point;
      const double squared = glm::dot(way, way);
      const glm::dvec3 expected = diffuse / kPi * intensity * (way.z / std::sqrt(squared)) / squared;
      for (int c = 0; c < 3; ++c) {
        ASSERT_NEAR(colors[4 * (y * kSize + x) + c], expected[c], kRelative * expected[c]) << x << "," << y;
      }
    }
  }
}

class MirrorCorridor : public AnalyticScene {};

// Between two mirrors of reflectance r at z = -1 and z = 1 the ray goes to and fro; a lamp-free emission e on both
// sums to e (1 + r + ... + r^n) for n reflections. The eye looks straight down the corridor.
TEST_F(MirrorCorridor, SumsTheGeometricSeriesUpToDepth1000) {
  constexpr float kReflectance = 0.9921875f, kEmission = 0.015625f;
  Material wall = mirror(kReflectance);
  wall.emission = glm::vec3(kEmission);
  add_rectangle(scene_, {-9, -9, -1}, {18, 0, 0}, {0, 18, 0}, wall);
  add_rectangle(scene_, {-9, -9, 1}, {0, 18, 0}, {18, 0, 0}, wall);
  look_from({0, 0.125, 0}, 0.01);
  RenderSettings settings;
  settings.width = settings.height = 3;
  settings.cutoff = 0.0f;
  for (const std::uint32_t depth : {0u, 1u, 33u, 64u, 1000u}) {
    settings.max_bounces = depth;
    const double expected = kEmission * (1.0 - std::pow(kReflectance, depth + 1.0)) / (1.0 - kReflectance);
    const std::vector<float> colors = render(settings);
    // A rounding per bounce and colour, summed.
    for (int pixel = 0; pixel < 9; ++pixel) {
      EXPECT_NEAR(colors[4 * pixel], expected, (depth + 4.0) * 0x1p-24 * expected) << "depth " << depth;
    }
  }
}

}  // namespace
}  // namespace vernier::golden
