#include "reference/camera_rays.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace vernier::reference {
namespace {

void expect_near(const glm::dvec3& a, const glm::dvec3& b) {
  EXPECT_LT(glm::distance(a, b), 1e-15) << a.x << ' ' << a.y << ' ' << a.z;
}

TEST(CameraRay, PerspectiveCentreAndCorners) {
  Camera camera;
  camera.vertical_fov = std::numbers::pi / 2.0;  // slope 1
  const Ray centre = camera_ray(camera, 200, 100, {100, 50});
  expect_near(centre.origin, {0, 0, 0});
  expect_near(centre.direction, {0, 0, -1});
  expect_near(camera_ray(camera, 200, 100, {0, 0}).direction, glm::normalize(glm::dvec3(-2, 1, -1)));
  expect_near(camera_ray(camera, 200, 100, {200, 100}).direction, glm::normalize(glm::dvec3(2, -1, -1)));
}

TEST(CameraRay, FollowsTheCamerasAxes) {
  Camera camera;
  camera.vertical_fov = 2.0 * std::atan(0.5);
  // Looks along +X: right is +Z, up +Y, back -X.
  camera.world_from_camera =
      glm::dmat4(glm::dvec4(0, 0, 1, 0), glm::dvec4(0, 1, 0, 0), glm::dvec4(-1, 0, 0, 0), glm::dvec4(5, 6, 7, 1));
  const Ray ray = camera_ray(camera, 100, 100, {75, 50});
  expect_near(ray.origin, {5, 6, 7});
  expect_near(ray.direction, glm::normalize(glm::dvec3(1, 0, 0.25)));
}

TEST(CameraRay, OrthographicRaysAreParallel) {
  Camera camera;
  camera.orthographic = true;
  camera.half_height = 3.0;
  const Ray ray = camera_ray(camera, 200, 100, {200, 0});
  expect_near(ray.origin, {6, 3, 0});
  expect_near(ray.direction, {0, 0, -1});
}

}  // namespace
}  // namespace vernier::reference
