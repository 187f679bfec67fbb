#include <gtest/gtest.h>

#include "shader/shader.h"

namespace vernier::shader {
namespace {

/// 90 degrees upright, twice as wide as high, at (1, 2, 3), looking along -Z.
Memory wide_camera(bool orthographic) {
  Memory scene;
  scene.render.camera_origin = vec3(1, 2, 3);
  scene.render.camera_right = vec3(2, 0, 0);
  scene.render.camera_up = vec3(0, 1, 0);
  scene.render.camera_forward = vec3(0, 0, -1);
  scene.render.image_width = 200;
  scene.render.image_height = 100;
  scene.dispatch.steering.orthographic = orthographic ? 1 : 0;
  return scene;
}

TEST(Camera, perspective_rays_leave_one_point) {
  Memory scene = wide_camera(false);
  const BoundMemory bound(scene);
  EXPECT_EQ(camera_ray(vec2(100, 50)).direction, vec3(0, 0, -1));
  EXPECT_EQ(camera_ray(vec2(0, 0)).origin, vec3(1, 2, 3));
  // Row 0 is on top, column 0 on the left.
  EXPECT_LT(glm::distance(camera_ray(vec2(0, 0)).direction, glm::normalize(vec3(-2, 1, -1))), 2e-7f);
  EXPECT_LT(glm::distance(camera_ray(vec2(200, 100)).direction, glm::normalize(vec3(2, -1, -1))), 2e-7f);
  EXPECT_LT(glm::distance(camera_ray(vec2(150, 50)).direction, glm::normalize(vec3(1, 0, -1))), 2e-7f);
}

TEST(Camera, the_middle_of_a_wide_field_keeps_its_digits) {
  // 179.99 degrees, tan = 11459: a step of 2^-24 at the middle of the image would turn the ray by 7e-4.
  Memory scene = wide_camera(false);
  scene.render.camera_right = vec3(11459, 0, 0);
  scene.render.camera_up = vec3(0, 11459, 0);
  scene.render.image_width = 3000;
  scene.render.image_height = 3000;
  const BoundMemory bound(scene);
  const float x = 1500.0f + 0x1p-13f;  // the step of floats there
  const vec3 exact = glm::normalize(glm::dvec3(11459 * (2 * double(x) - 3000) / 3000, 0, -1));
  EXPECT_LT(glm::distance(camera_ray(vec2(x, 1500)).direction, exact), 2e-7f);
}

TEST(Camera, orthographic_rays_are_parallel) {
  Memory scene = wide_camera(true);
  const BoundMemory bound(scene);
  for (const vec2& pixel : {vec2(0, 0), vec2(30, 80)}) EXPECT_EQ(camera_ray(pixel).direction, vec3(0, 0, -1));
  EXPECT_EQ(camera_ray(vec2(0, 0)).origin, vec3(-1, 3, 3));
  EXPECT_EQ(camera_ray(vec2(200, 100)).origin, vec3(3, 1, 3));
}

TEST(Camera, a_pipeline_without_parallel_rays_has_perspective) {
  Memory scene = wide_camera(true);
  const BoundMemory bound(scene);
  EFFECTS = ~EFFECT_ORTHOGRAPHIC;
  EXPECT_EQ(camera_ray(vec2(0, 0)).origin, vec3(1, 2, 3));
  EFFECTS = 0xffffffffu;
}

}  // namespace
}  // namespace vernier::shader
