#include "preview/orbit_view.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace vernier {
namespace {

/// A few operations on numbers about 1 to 10, each rounded to 2^-53 of them.
constexpr double kRounding = 1e-13;
constexpr double kPi = 3.14159265358979323846;

WorldBounds unit_box() {
  return {glm::dvec3(-1.0), glm::dvec3(1.0)};
}

Camera camera_at(const glm::dvec3& eye) {
  Camera camera;
  camera.world_from_camera[3] = glm::dvec4(eye, 1.0);
  return camera;
}

glm::dvec3 eye_of(const OrbitView& view) {
  return glm::dvec3(view.camera.world_from_camera[3]);
}

double distance_of(const OrbitView& view) {
  return glm::length(view.target - eye_of(view));
}

void expect_near(const glm::dvec3& a, const glm::dvec3& b) {
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(a[axis], b[axis], kRounding) << "axis " << axis;
}

void expect_rigid(const OrbitView& view) {
  const glm::dmat3 axes(view.camera.world_from_camera);
  const glm::dmat3 product = glm::transpose(axes) * axes;
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) EXPECT_NEAR(product[column][row], column == row ? 1.0 : 0.0, kRounding);
  }
}

TEST(OrbitViewTest, TargetIsTheNearestPointOfTheLineOfSight) {
  expect_near(orbit_view(camera_at({0.5, 0.25, 5.0}), unit_box()).target, {0.5, 0.25, 0.0});
}

TEST(OrbitViewTest, TargetStaysInFrontOfTheEye) {
  // The box lies behind a camera that looks along -Z from below it.
  const OrbitView view = orbit_view(camera_at({0.0, 0.0, -5.0}), unit_box());
  EXPECT_LT(view.target.z, -5.0);
}

TEST(OrbitViewTest, EmptyBoundsHaveATargetToo) {
  const double infinity = std::numeric_limits<double>::infinity();
  const OrbitView view = orbit_view(camera_at({0.0, 0.0, 2.0}), {glm::dvec3(infinity), glm::dvec3(-infinity)});
  expect_near(view.target, glm::dvec3(0.0));
}

TEST(OrbitViewTest, AQuarterTurnToTheRightMovesTheEyeToTheLeftOfTheTarget) {
  const OrbitView turned = orbited(orbit_view(camera_at({0.0, 0.0, 5.0}), unit_box()), kPi / 2.0, 0.0);
  expect_near(eye_of(turned), {-5.0, 0.0, 0.0});
  expect_near(glm::dvec3(turned.camera.world_from_camera[2]), {-1.0, 0.0, 0.0});
  expect_rigid(turned);
}

TEST(OrbitViewTest, TurningKeepsTargetAndDistance) {
  const OrbitView view = orbit_view(camera_at({0.3, 0.7, 5.0}), unit_box());
  OrbitView turned = view;
  for (int step = 0; step < 100; ++step) turned = orbited(turned, 0.1, 0.03);
  expect_near(turned.target, view.target);
  EXPECT_NEAR(distance_of(turned), distance_of(view), 100.0 * kRounding);
}

TEST(OrbitViewTest, NothingGoesOverThePole) {
  OrbitView view = orbit_view(camera_at({0.0, 0.0, 5.0}), unit_box());
  for (int step = 0; step < 50; ++step) view = orbited(view, 0.0, 0.2);
  EXPECT_GT(view.camera.world_from_camera[1].y, 0.0) << "upside down";
  EXPECT_NEAR(view.camera.world_from_camera[1].y, std::sin(kPi / 180.0), kRounding) << "a degree from the pole";
  for (int step = 0; step < 50; ++step) view = orbited(view, 0.0, -0.2);
  EXPECT_NEAR(view.camera.world_from_camera[1].y, std::sin(kPi / 180.0), kRounding);
}

TEST(OrbitViewTest, ThereAndBackIsWhereItWas) {
  const OrbitView view = orbit_view(camera_at({1.0, 2.0, 5.0}), unit_box());
  const OrbitView back = orbited(orbited(view, 0.7, -0.3), -0.7, 0.3);
  for (int column = 0; column < 4; ++column) {
    expect_near(glm::dvec3(back.camera.world_from_camera[column]), glm::dvec3(view.camera.world_from_camera[column]));
  }
}

TEST(OrbitViewTest, PanningByOneHeightMovesTheTargetByWhatIsSeen) {
  OrbitView view = orbit_view(camera_at({0.0, 0.0, 5.0}), unit_box());
  view.camera.vertical_fov = kPi / 2.0;
  expect_near(panned(view, 0.0, 1.0).target, {0.0, 10.0, 0.0});
  view.camera.orthographic = true;
  view.camera.half_height = 3.0;
  expect_near(panned(view, 1.0, 0.0).target, {6.0, 0.0, 0.0});
}

TEST(OrbitViewTest, ZoomingScalesTheDistanceOrWhatAnOrthographicCameraSees) {
  OrbitView view = orbit_view(camera_at({0.0, 0.0, 5.0}), unit_box());
  EXPECT_NEAR(distance_of(zoomed(view, 0.5)), 2.5, kRounding);
  view.camera.orthographic = true;
  EXPECT_NEAR(zoomed(view, 0.5).camera.half_height, view.camera.half_height * 0.5, kRounding);
  EXPECT_NEAR(distance_of(zoomed(view, 0.5)), 5.0, kRounding);
}

TEST(OrbitViewTest, WalkingForwardTakesTheTargetAlong) {
  const OrbitView view = orbit_view(camera_at({0.0, 0.0, 5.0}), unit_box());
  const OrbitView walked = moved(view, {0.0, 0.0, 0.2});
  expect_near(eye_of(walked), {0.0, 0.0, 4.0});
  expect_near(walked.target, {0.0, 0.0, -1.0});
}

TEST(OrbitViewTest, FramingSeesTheMiddleOfTheBounds) {
  const OrbitView view = framed(orbit_view(camera_at({0.0, 9.0, 5.0}), unit_box()), unit_box(), 1.5);
  // The picture is centred on the outline of the box, whose middle lies within a tenth of its diagonal of the box's.
  EXPECT_LT(glm::length(view.target), 0.1 * 2.0 * std::sqrt(3.0));
  EXPECT_GT(distance_of(view), std::sqrt(3.0)) << "the eye is outside";
}

}  // namespace
}  // namespace vernier
