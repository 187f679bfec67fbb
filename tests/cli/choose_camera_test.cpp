#include "cli/choose_camera.h"

#include "unit_square.h"
#include "usage_error.h"

namespace vernier {
namespace {

Scene scene_with_cameras() {
  Scene scene = unit_square();
  Camera front;
  front.name = "front";
  front.world_from_camera[3] = glm::dvec4(1, 1, 5, 1);
  front.vertical_fov = 0.5;
  Camera plan = front;
  plan.name = "0";
  plan.orthographic = true;
  scene.cameras = {front, plan};
  return scene;
}

glm::dvec3 column(const Camera& camera, int index) {
  return glm::dvec3(camera.world_from_camera[index]);
}

void expect_near(const glm::dvec3& actual, const glm::dvec3& expected) {
  constexpr double kRounding = 1e-14;  // a handful of double operations on values near 1
  EXPECT_LE(glm::length(actual - expected), kRounding) << actual.x << " " << actual.y << " " << actual.z;
}

TEST(ChooseCamera, FirstOfTheFileByDefault) {
  EXPECT_EQ(choose_camera(scene_with_cameras(), SceneSettings{}, 1.5).name, "front");
}

TEST(ChooseCamera, NameGoesBeforeIndex) {
  SceneSettings settings;
  settings.camera = "1";
  EXPECT_EQ(choose_camera(scene_with_cameras(), settings, 1.5).name, "0") << "index 1";
  settings.camera = "0";
  EXPECT_TRUE(choose_camera(scene_with_cameras(), settings, 1.5).orthographic) << "the camera called 0";
  for (const char* unknown : {"2", "back", "-1", "1x", "99999999999999999999"}) {
    settings.camera = unknown;
    expect_usage_error("1 (0)", [&] { choose_camera(scene_with_cameras(), settings, 1.5); });
  }
}

TEST(ChooseCamera, FramesASceneWithoutCamera) {
  const Camera camera = choose_camera(unit_square(), SceneSettings{}, 1.0);
  EXPECT_GT(glm::dot(glm::dvec3(1, 1, 0) - column(camera, 3), -column(camera, 2)), 0.0) << "looks at it";
}

TEST(ChooseCamera, EyeAloneLooksAtTheCentre) {
  SceneSettings settings;
  settings.eye = glm::dvec3(1, 1, 7);
  const Camera camera = choose_camera(scene_with_cameras(), settings, 1.0);
  expect_near(column(camera, 3), {1, 1, 7});
  expect_near(-column(camera, 2), {0, 0, -1});
  expect_near(column(camera, 1), {0, 1, 0});
  EXPECT_EQ(camera.vertical_fov, 0.5) << "the file's";
}

TEST(ChooseCamera, TargetAloneTurns) {
  SceneSettings settings;
  settings.target = glm::dvec3(6, 1, 5);
  const Camera camera = choose_camera(scene_with_cameras(), settings, 1.0);
  expect_near(column(camera, 3), {1, 1, 5});
  expect_near(-column(camera, 2), {1, 0, 0});
}

TEST(ChooseCamera, UpAloneRolls) {
  SceneSettings settings;
  settings.up = glm::dvec3(3, 0, 0);
  const Camera camera = choose_camera(scene_with_cameras(), settings, 1.0);
  expect_near(-column(camera, 2), {0, 0, -1});
  expect_near(column(camera, 1), {1, 0, 0});
  expect_near(column(camera, 0), {0, -1, 0});
}

TEST(ChooseCamera, LooksStraightDownWithoutUp) {
  SceneSettings settings;
  settings.eye = glm::dvec3(1, 9, 0);
  settings.target = glm::dvec3(1, 1, 0);
  expect_near(column(choose_camera(scene_with_cameras(), settings, 1.0), 1), {0, 0, -1});
  settings.up = glm::dvec3(0, 1, 0);
  expect_usage_error("--up", [&] { choose_camera(scene_with_cameras(), settings, 1.0); });
}

TEST(ChooseCamera, EyeMayBeVeryFar) {
  SceneSettings settings;
  settings.eye = glm::dvec3(1, 1, 1e200);
  expect_near(-column(choose_camera(scene_with_cameras(), settings, 1.0), 2), {0, 0, -1});
}

TEST(ChooseCamera, EyeAtTheTargetIsRefused) {
  SceneSettings settings;
  settings.eye = glm::dvec3(1, 1, 0);
  expect_usage_error("--eye", [&] { choose_camera(scene_with_cameras(), settings, 1.0); });
}

TEST(ChooseCamera, FovReplacesThatOfPerspectiveCameras) {
  SceneSettings settings;
  settings.vertical_fov = 1.0;
  EXPECT_EQ(choose_camera(scene_with_cameras(), settings, 1.0).vertical_fov, 1.0);
  EXPECT_EQ(choose_camera(unit_square(), settings, 1.0).vertical_fov, 1.0);
  settings.camera = "0";
  expect_usage_error("orthographic", [&] { choose_camera(scene_with_cameras(), settings, 1.0); });
}

TEST(ChooseCamera, ViewHeightReplacesThatOfOrthographicCameras) {
  SceneSettings settings;
  settings.view_height = 3.0;
  expect_usage_error("--view-height", [&] { choose_camera(unit_square(), settings, 1.0); });
  settings.camera = "0";
  EXPECT_EQ(choose_camera(scene_with_cameras(), settings, 1.0).half_height, 1.5);
}

}  // namespace
}  // namespace vernier
