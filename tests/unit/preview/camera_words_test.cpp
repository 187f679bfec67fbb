#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

// Before what shaders read too: CLI11 has a NONE of its own.
#include "cli/choose_camera.h"
#include "preview/camera_words.h"

namespace vernier {
namespace {

/// The camera that the command line makes of `words`.
Camera chosen(const CameraWords& words) {
  SceneArguments arguments;
  arguments.eye = words.eye;
  arguments.target = words.target;
  arguments.up = words.up;
  arguments.view_height = words.view_height;
  Scene scene;
  scene.cameras.emplace_back().orthographic = !words.view_height.empty();
  return choose_camera(scene, parse_scene_settings(arguments), 1.5);
}

OrbitView somewhere(double roll) {
  Camera camera;
  camera.world_from_camera = glm::translate(glm::dmat4(1.0), glm::dvec3(0.1, 1.0 / 3.0, 7.0)) *
                             glm::rotate(glm::dmat4(1.0), roll, glm::dvec3(0.0, 0.0, 1.0));
  const OrbitView view = orbit_view(camera, {glm::dvec3(-1.0), glm::dvec3(1.0)});
  return roll == 0.0 ? orbited(view, 0.4, 0.2) : view;
}

void expect_same_view(const Camera& a, const Camera& b) {
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 3; ++row) {
      // The axes are made anew from two points ten metres apart, each rounded to 2^-53.
      EXPECT_NEAR(a.world_from_camera[column][row], b.world_from_camera[column][row], 1e-14 * 10.0);
    }
  }
}

TEST(CameraWordsTest, TheCommandLineLooksTheSameWay) {
  const OrbitView view = somewhere(0.0);
  const CameraWords words = camera_words({}, view);
  EXPECT_EQ(words.up, "") << "upright";
  expect_same_view(chosen(words), view.camera);
}

TEST(CameraWordsTest, ARolledCameraSaysUp) {
  const OrbitView view = somewhere(0.3);
  const CameraWords words = camera_words({}, view);
  EXPECT_NE(words.up, "");
  expect_same_view(chosen(words), view.camera);
}

TEST(CameraWordsTest, EyeKeepsEveryDigit) {
  const Camera camera = chosen(camera_words({}, somewhere(0.3)));
  EXPECT_EQ(camera.world_from_camera[3], somewhere(0.3).camera.world_from_camera[3]);
}

TEST(CameraWordsTest, WhatAnOrthographicCameraSeesKeepsEveryDigit) {
  OrbitView view = somewhere(0.0);
  EXPECT_EQ(camera_words({}, view).view_height, "") << "perspective";
  view.camera.orthographic = true;
  view.camera.half_height = 1.0 / 3.0;
  EXPECT_EQ(chosen(camera_words({}, view)).half_height, 1.0 / 3.0);
}

TEST(CameraWordsTest, CameraAndFieldOfViewStay) {
  const CameraWords words = camera_words(
      {.camera = "2", .eye = "1,2,3", .target = {}, .up = {}, .fov = "40", .view_height = {}}, somewhere(0.0));
  EXPECT_EQ(words.camera, "2");
  EXPECT_EQ(words.fov, "40");
  EXPECT_NE(words.eye, "1,2,3");
}

}  // namespace
}  // namespace vernier
