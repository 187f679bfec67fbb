#include "effects/light_reach.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "one_triangle.h"

namespace vernier {
namespace {

Light lamp_at(const glm::dvec3& position, double range) {
  Light light = light_of(LightKind::point);
  light.position = position;
  light.range = range;
  return light;
}

TEST(WorldBounds, encloses_every_placed_mesh) {
  Scene scene = one_triangle();
  Instance moved;
  moved.world_from_object = glm::translate(glm::dmat4(1.0), glm::dvec3(5, 0, -2));
  scene.instances.push_back(moved);
  const WorldBounds box = world_box(scene);
  EXPECT_EQ(box.lo, glm::dvec3(0, 0, -2));
  EXPECT_EQ(box.hi, glm::dvec3(6, 1, 0));
}

TEST(LightReach, ends_at_the_range) {
  const WorldBounds box = world_box(one_triangle());  // [0, 1] x [0, 1] x [0, 0]
  EXPECT_TRUE(light_reaches(lamp_at({3, 0.5, 0}, 2.5), box));
  EXPECT_TRUE(light_reaches(lamp_at({3, 0.5, 0}, 2.0), box));  // just touches: in doubt
  EXPECT_FALSE(light_reaches(lamp_at({3, 0.5, 0}, 1.9), box));
  EXPECT_TRUE(light_reaches(lamp_at({0.5, 0.5, 0}, 1e-3), box));  // inside
  EXPECT_FALSE(light_reaches(lamp_at({2, 2, 1}, 1.7), box));      // the corner is sqrt(3) away
  EXPECT_TRUE(light_reaches(lamp_at({2, 2, 1}, 1.74), box));
  EXPECT_TRUE(light_reaches(lamp_at({1e9, 0, 0}, std::numeric_limits<double>::infinity()), box));
}

TEST(LightReach, a_light_out_of_reach_asks_for_nothing) {
  Scene scene = white_triangle();
  scene.lights = {lamp_at({10, 0, 0}, 5.0)};
  EXPECT_FALSE(is_on(scene, EFFECT_POINT_LIGHTS));
  EXPECT_FALSE(is_on(scene, EFFECT_SHADOWS));
  scene.lights[0].range = 20.0;
  EXPECT_TRUE(is_on(scene, EFFECT_POINT_LIGHTS));
  EXPECT_TRUE(is_on(scene, EFFECT_SHADOWS));
}

}  // namespace
}  // namespace vernier
