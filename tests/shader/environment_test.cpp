#include <gtest/gtest.h>

#include <array>
#include <numbers>

#include "scene/environment_harmonics.h"
#include "shader/random_values.h"
#include "shader/shader.h"

namespace vernier::shader {
namespace {

TEST(Environment, angle_of_is_atan2) {
  RandomValues random(12);
  for (int i = 0; i < 400000; ++i) {
    const float scale = random.power_of_ten(-30, 30);
    const float x = random.in(-1, 1) * scale;
    const float y = random.in(-1, 1) * scale * (i % 3 == 0 ? 1e-4f : 1.0f);
    // 2e-7 for the series (environment.glsl) and an ulp of pi, 2.4e-7, for the last differences.
    ASSERT_NEAR(angle_of(y, x), std::atan2(double(y), double(x)), 4.4e-7) << y << ' ' << x;
  }
}

TEST(Environment, arc_tangent_to_the_figure_it_promises) {
  for (int i = 0; i <= 1 << 20; ++i) {
    const float x = static_cast<float>(i) * 0x1p-20f;
    ASSERT_NEAR(arc_tangent(x), std::atan(double(x)), 2e-7) << x;
  }
}

TEST(Environment, angle_of_the_axes) {
  const float pi = std::numbers::pi_v<float>;
  EXPECT_EQ(angle_of(0.0f, 0.0f), 0.0f);
  EXPECT_EQ(angle_of(0.0f, 2.0f), 0.0f);
  EXPECT_FLOAT_EQ(angle_of(3.0f, 0.0f), pi / 2);
  EXPECT_FLOAT_EQ(angle_of(-3.0f, 0.0f), -pi / 2);
  EXPECT_FLOAT_EQ(angle_of(0.0f, -1.0f), pi);
  EXPECT_FLOAT_EQ(angle_of(1.0f, 1.0f), pi / 4);
  EXPECT_FLOAT_EQ(angle_of(-1.0f, -1.0f), -3 * pi / 4);
}

TEST(Environment, the_gradient_runs_from_ground_to_sky) {
  Memory scene;
  scene.render.sky = vec3(0, 2, 8);
  scene.render.ground = vec3(4, 2, 0);
  scene.dispatch.steering.environment_texture = NONE;
  const BoundMemory bound(scene);
  EXPECT_EQ(environment_radiance(vec3(0, 1, 0)), scene.render.sky);
  EXPECT_EQ(environment_radiance(vec3(0, -1, 0)), scene.render.ground);
  EXPECT_EQ(environment_radiance(vec3(1, 0, 0)), vec3(2, 2, 4));
  EXPECT_EQ(environment_radiance(vec3(0, 0.5f, 0)), vec3(1, 2, 6));
}

/// An environment image of 4 x 2 texels: red counts the columns, green the rows, from 1; times a scale.
Memory image_environment() {
  Memory scene;
  scene.textures = {glm::uvec4(4, 2, 0,
                               TEXTURE_FORMAT_FLOAT | TEXTURE_WRAP_CLAMP << TEXTURE_WRAP_V_SHIFT |
                                   TEXTURE_FILTER_NEAREST << TEXTURE_FILTER_SHIFT)};
  for (std::uint32_t row = 0; row < 2; ++row) {
    for (std::uint32_t column = 0; column < 4; ++column) {
      for (float value : {column + 1.0f, row + 1.0f, 0.0f, 1.0f}) scene.texels.push_back(glm::floatBitsToUint(value));
    }
  }
  scene.dispatch.steering.environment_texture = 0;
  scene.render.environment_scale = vec3(1, 10, 1);
  return scene;
}

TEST(Environment, an_image_is_read_by_longitude_and_latitude) {
  Memory scene = image_environment();
  const BoundMemory bound(scene);
  const float h = std::sqrt(0.5f);
  // -z is the middle of the image, x a quarter to the right of it, z its edge; the columns' centres lie at 45 degrees.
  EXPECT_EQ(environment_radiance(vec3(0.6f, h, -0.6f) * 1.0f), vec3(3, 10, 0));
  EXPECT_EQ(environment_radiance(unit_vector(vec3(0.6f, -h, 0.6f))), vec3(4, 20, 0));
  EXPECT_EQ(environment_radiance(unit_vector(vec3(-0.6f, h, 0.6f))), vec3(1, 10, 0));
  EXPECT_EQ(environment_radiance(unit_vector(vec3(-0.6f, -h, -0.6f))), vec3(2, 20, 0));
}

TEST(Environment, an_image_switched_off_is_the_gradient) {
  Memory scene = image_environment();
  scene.render.sky = scene.render.ground = vec3(5);
  const BoundMemory bound(scene);
  EFFECTS = ~EFFECT_ENVIRONMENT_MAP;
  EXPECT_EQ(environment_radiance(vec3(0, 0, -1)), vec3(5));
  EFFECTS = 0xffffffffu;
}

/// Cosine-weighted mean of sky and ground mixed by height, by quadrature over the hemisphere around n.
double gradient_mean(const glm::dvec3& n, double sky, double ground) {
  const glm::dvec3 side =
      glm::normalize(glm::cross(n, std::abs(n.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
  const glm::dvec3 other = glm::cross(n, side);
  double sum = 0;
  constexpr int kSteps = 200;
  for (int i = 0; i < kSteps; ++i) {
    for (int k = 0; k < kSteps; ++k) {
      const double squared = (i + 0.5) / kSteps;  // of the radius in the disc: equal shares of the cosine
      const double angle = 2 * std::numbers::pi * (k + 0.5) / kSteps;
      const glm::dvec3 d =
          n * std::sqrt(1 - squared) + (side * std::cos(angle) + other * std::sin(angle)) * std::sqrt(squared);
      sum += ground + (sky - ground) * (1 + d.y) / 2;
    }
  }
  return sum / (kSteps * kSteps);
}

TEST(Environment, ambient_light_is_the_mean_around_the_normal) {
  Scene scene;
  scene.environment.sky = vec3(0.2f, 3, 1);
  scene.environment.ground = vec3(0.9f, 1, 1);
  Memory shading;
  const std::array<vec3, 9> harmonics = ambient_harmonics(scene);
  for (std::size_t i = 0; i < 9; ++i) shading.render.ambient_harmonics[i] = harmonics[i];
  const BoundMemory bound(shading);
  for (const vec3& n : {vec3(0, 1, 0), vec3(0, -1, 0), vec3(1, 0, 0), vec3(0.6f, 0.64f, 0.48f)}) {
    const vec3 ambient = ambient_radiance(n);
    EXPECT_NEAR(ambient.x, gradient_mean(n, 0.2, 0.9), 1e-4);  // quadrature of 200 steps
    EXPECT_NEAR(ambient.y, gradient_mean(n, 3, 1), 1e-4);
    EXPECT_NEAR(ambient.z, 1, 1e-6);
  }
}

TEST(Environment, every_harmonic_stands_for_its_polynomial) {
  const vec3 n(0.6f, 0.64f, 0.48f);
  const std::array<float, 9> values = {
      1, n.y, n.z, n.x, n.x * n.y, n.y * n.z, 3 * n.z * n.z - 1, n.x * n.z, n.x * n.x - n.y * n.y};
  for (std::size_t i = 0; i < 9; ++i) {
    Memory shading;
    shading.render.ambient_harmonics[i] = vec3(2, -2, 0);
    const BoundMemory bound(shading);
    EXPECT_NEAR(ambient_radiance(n).x, std::max(2 * values[i], 0.0f), 1e-6) << i;
    EXPECT_NEAR(ambient_radiance(n).y, std::max(-2 * values[i], 0.0f), 1e-6) << i;
  }
}

}  // namespace
}  // namespace vernier::shader
