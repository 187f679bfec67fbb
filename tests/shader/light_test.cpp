#include <gtest/gtest.h>

#include <limits>

#include "shader/random_values.h"
#include "shader/shader.h"

namespace vernier::shader {
namespace {

DeviceLight point_light(vec3 position, float intensity) {
  DeviceLight light{};
  light.kind = LIGHT_POINT;
  light.position = position;
  light.intensity = vec3(intensity);
  light.range = std::numeric_limits<float>::infinity();
  return light;
}

DeviceLight spot_light(float cos_inner, float cos_outer) {
  DeviceLight light = point_light(vec3(0, 1, 0), 1.0f);
  light.kind = LIGHT_SPOT;
  light.direction = vec3(0, -1, 0);
  light.cos_outer = cos_outer;
  light.cone_scale = 1.0f / (cos_inner - cos_outer);
  return light;
}

TEST(Light, fetched_field_by_field) {
  Memory scene;
  for (std::uint32_t texel = 0; texel < 2 * LIGHT_TEXELS; ++texel) {
    const auto bits = [&](std::uint32_t i) { return glm::floatBitsToUint(static_cast<float>(4 * texel + i)); };
    scene.lights.push_back({bits(0), bits(1), bits(2), bits(3)});
  }
  scene.lights[4].w = LIGHT_SPOT;
  const BoundMemory bound(scene);
  const DeviceLight light = fetch_light(1u);
  EXPECT_EQ(light.position, vec3(16, 17, 18));
  EXPECT_EQ(light.kind, LIGHT_SPOT);
  EXPECT_EQ(light.direction, vec3(20, 21, 22));
  EXPECT_EQ(light.range, 23.0f);
  EXPECT_EQ(light.intensity, vec3(24, 25, 26));
  EXPECT_EQ(light.cos_outer, 27.0f);
  EXPECT_EQ(light.cone_scale, 28.0f);
}

TEST(Light, a_point_light_fades_with_the_square) {
  const LightSample sample = sample_light(point_light(vec3(0, 2, 0), 8.0f), vec3(0));
  EXPECT_EQ(sample.direction, vec3(0, 1, 0));
  EXPECT_EQ(sample.irradiance, vec3(2));
  EXPECT_EQ(sample.offset, vec3(0, 2, 0));
  EXPECT_FALSE(sample.directional);
}

TEST(Light, any_distance_gives_a_finite_irradiance_of_its_size) {
  RandomValues random(13);
  for (int i = 0; i < 20000; ++i) {
    // The square of the distance alone would leave the range of floats beyond 10^-19 and 10^19.
    const float distance = random.power_of_ten(-18, 18);
    const vec3 offset = random.direction() * distance;
    const float intensity = distance < 1.0f ? distance : 1e10f;
    const double exact = intensity / glm::dot(glm::dvec3(offset), glm::dvec3(offset));
    const LightSample sample = sample_light(point_light(offset, intensity), vec3(0));
    if (exact < 1e-37) continue;  // a denormal has fewer digits
    ASSERT_NEAR(sample.irradiance.x / exact, 1.0, 1e-6) << distance;
  }
}

TEST(Light, a_light_in_the_point_itself_gives_nothing) {
  const LightSample sample = sample_light(point_light(vec3(1, 2, 3), 8.0f), vec3(1, 2, 3));
  EXPECT_EQ(sample.irradiance, vec3(0));
  EXPECT_EQ(sample.direction, vec3(0));
}

TEST(Light, the_range_fades_it_out) {
  DeviceLight light = point_light(vec3(0, 2, 0), 4.0f);
  light.range = 4.0f;
  EXPECT_FLOAT_EQ(sample_light(light, vec3(0)).irradiance.x, 1.0f - 1.0f / 16.0f);
  light.range = 2.0f;
  EXPECT_EQ(sample_light(light, vec3(0)).irradiance.x, 0.0f);
  light.range = 1.0f;
  EXPECT_EQ(sample_light(light, vec3(0)).irradiance.x, 0.0f);
}

TEST(Light, a_spot_falls_off_between_its_cones) {
  const DeviceLight light = spot_light(0.9f, 0.8f);
  const auto at_cosine = [&](float cosine) {
    const vec3 offset = vec3(std::sqrt(1.0f - cosine * cosine), -cosine, 0);
    return sample_light(light, light.position + offset).irradiance.x;
  };
  EXPECT_FLOAT_EQ(at_cosine(1.0f), 1.0f);
  EXPECT_NEAR(at_cosine(0.91f), 1.0f, 1e-6);
  EXPECT_NEAR(at_cosine(0.85f), 0.25f, 1e-5);
  EXPECT_EQ(at_cosine(0.79f), 0.0f);
  EXPECT_EQ(at_cosine(-1.0f), 0.0f);
}

TEST(Light, a_directional_light_is_the_same_everywhere) {
  DeviceLight light = point_light(vec3(7), 3.0f);
  light.kind = LIGHT_DIRECTIONAL;
  light.direction = vec3(0, 0, -1);
  for (const vec3& place : {vec3(0), vec3(1e6f, 0, -5)}) {
    const LightSample sample = sample_light(light, place);
    EXPECT_EQ(sample.direction, vec3(0, 0, 1));
    EXPECT_EQ(sample.irradiance, vec3(3));
    EXPECT_TRUE(sample.directional);
  }
}

}  // namespace
}  // namespace vernier::shader
