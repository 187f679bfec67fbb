#include "reference/light_arrival.h"

#include <gtest/gtest.h>

#include <cmath>

#include "reference/fresnel.h"
#include "test_scenes.h"

namespace vernier::reference {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

void expect_near(const glm::dvec3& a, const glm::dvec3& b) {
  EXPECT_LT(glm::distance(a, b), 1e-7) << a.x << ' ' << a.y << ' ' << a.z;
}

TEST(LightArrival, PointLightFallsWithTheSquare) {
  Light light;
  light.position = {0, 0, 2};
  light.intensity = {8.0f, 4.0f, 0.0f};
  const auto arrival = light_arrival(light, {0, 0, -2});
  ASSERT_TRUE(arrival);
  expect_near(arrival->direction, {0, 0, 1});
  EXPECT_DOUBLE_EQ(arrival->distance, 4.0);
  expect_near(arrival->irradiance, {0.5, 0.25, 0.0});
  EXPECT_FALSE(light_arrival(light, light.position));
}

TEST(LightArrival, RangeFadesToNothing) {
  Light light;
  light.range = 2.0;
  const auto red = [&](double distance) {
    const auto arrival = light_arrival(light, {distance, 0, 0});
    return arrival ? arrival->irradiance.x : 0.0;
  };
  EXPECT_DOUBLE_EQ(red(1.0), 15.0 / 16.0);
  EXPECT_EQ(red(2.0), 0.0);
  EXPECT_EQ(red(3.0), 0.0);
}

TEST(LightArrival, SpotConeIsQuadraticInTheCosine) {
  Light light;
  light.kind = LightKind::spot;
  light.inner_cone_angle = std::acos(0.9);
  light.outer_cone_angle = std::acos(0.7);
  const auto red = [&](double cosine) {
    const auto arrival = light_arrival(light, {std::sqrt(1.0 - cosine * cosine), 0, -cosine});
    return arrival ? arrival->irradiance.x : 0.0;
  };
  EXPECT_NEAR(red(1.0), 1.0, 1e-12);
  EXPECT_NEAR(red(0.91), 1.0, 1e-12);
  EXPECT_NEAR(red(0.8), 0.25, 1e-12);
  EXPECT_NEAR(red(0.75), 0.0625, 1e-12);
  EXPECT_EQ(red(0.69), 0.0);
  EXPECT_EQ(red(-1.0), 0.0);
}

TEST(LightArrival, DirectionalIsTheSameEverywhere) {
  Light light;
  light.kind = LightKind::directional;
  light.direction = {0, -1, 0};
  light.range = 1.0;
  const auto arrival = light_arrival(light, {1e6, -1e6, 3});
  ASSERT_TRUE(arrival);
  expect_near(arrival->direction, {0, 1, 0});
  EXPECT_EQ(arrival->distance, kInfinity);
  expect_near(arrival->irradiance, glm::dvec3(1.0));
  light.intensity = glm::vec3(0.0f);
  EXPECT_FALSE(light_arrival(light, {0, 0, 0}));
}

glm::dvec3 upwards(const Scene& scene, double distance = kInfinity) {
  return transmittance(prepare_scene(scene), {{0.1, 0.2, 0}, {0, 0, 1}}, distance, kNoTriangle);
}

Material glass() {
  Material material;
  material.roughness = 0.0f;
  material.transmission = glm::vec3(1.0f);
  return material;
}

TEST(Transmittance, OpaqueStopsOnlyBeforeTheLight) {
  Scene scene;
  test::add_black(scene);
  test::add_square(scene, 2.0f);
  EXPECT_EQ(upwards(scene), glm::dvec3(0.0));
  EXPECT_EQ(upwards(scene, 2.5), glm::dvec3(0.0));
  EXPECT_EQ(upwards(scene, 2.0), glm::dvec3(1.0));
  EXPECT_EQ(upwards(scene, 1.5), glm::dvec3(1.0));
}

TEST(Transmittance, BlendedLayersMultiply) {
  Scene scene;
  for (const float alpha : {0.5f, 0.25f, 0.0f}) {
    Material& material = test::add_black(scene);
    material.alpha_mode = AlphaMode::blend;
    material.base_color.w = alpha;
    test::add_square(scene, 1.0f + alpha);
  }
  expect_near(upwards(scene), glm::dvec3(0.5 * 0.75));
}

TEST(Transmittance, MaskIsAllOrNothing) {
  Scene scene;
  Material& material = test::add_black(scene);
  material.alpha_mode = AlphaMode::mask;
  material.base_color.w = 0.4f;
  test::add_square(scene, 1.0f);
  EXPECT_EQ(upwards(scene), glm::dvec3(1.0));
  scene.materials[0].alpha_cutoff = 0.3f;
  EXPECT_EQ(upwards(scene), glm::dvec3(0.0));
}

TEST(Transmittance, ThinGlassTintsAndReflects) {
  Scene scene;
  scene.materials.push_back(glass());
  scene.materials[0].base_color = {1.0f, 0.5f, 0.25f, 1.0f};
  test::add_square(scene, 1.0f);
  expect_near(upwards(scene), 0.96 * glm::dvec3(1, 0.5, 0.25));
  scene.materials[0].alpha_mode = AlphaMode::blend;
  scene.materials[0].base_color.w = 0.5f;
  expect_near(upwards(scene), 0.5 + 0.5 * 0.96 * glm::dvec3(1, 0.5, 0.25));
}

TEST(Transmittance, ObliqueGlassFollowsFresnel) {
  Scene scene;
  scene.materials.push_back(glass());
  test::add_square(scene, 1.0f, 10.0f);
  const Ray ray{{0.1, 0.2, 0}, {0.8, 0, 0.6}};
  const glm::dvec3 through = transmittance(prepare_scene(scene), ray, kInfinity, kNoTriangle);
  expect_near(through, glm::dvec3(1.0 - fresnel_reflectance(0.6, 1.5)));
}

TEST(Transmittance, BodiesAbsorbOverTheWayInside) {
  Scene scene;
  scene.materials.push_back(glass());
  scene.materials[0].thin_walled = false;
  scene.materials[0].absorption = {1.0f, 0.5f, 0.0f};
  test::add_box(scene, {-1, -1, 2}, {1, 1, 3.5});
  expect_near(upwards(scene), 0.96 * 0.96 * glm::exp(glm::dvec3(-1.5, -0.75, 0)));
  test::add_box(scene, {-1, -1, 5}, {1, 1, 5.5});
  expect_near(upwards(scene), std::pow(0.96, 4) * glm::exp(glm::dvec3(-2.0, -1.0, 0)));
}

TEST(Transmittance, FromInsideABodyTheWayOutCounts) {
  Scene scene;
  scene.materials.push_back(glass());
  scene.materials[0].thin_walled = false;
  scene.materials[0].absorption = {1.0f, 0.5f, 0.0f};
  test::add_box(scene, {-1, -1, -1}, {1, 1, 0.5});
  expect_near(upwards(scene), 0.96 * glm::exp(glm::dvec3(-0.5, -0.25, 0)));
}

// An entry without an exit before the light would count below zero: light in a body is not amplified.
TEST(Transmittance, ALightInABodyIsNotAmplified) {
  Scene scene;
  scene.materials.push_back(glass());
  scene.materials[0].thin_walled = false;
  scene.materials[0].absorption = glm::vec3(1.0f);
  test::add_box(scene, {-1, -1, 2}, {1, 1, 4});
  expect_near(upwards(scene, 3.0), glm::dvec3(0.96));
}

TEST(Transmittance, PlainMtlGlassHasNoFresnelInShadows) {
  Scene scene;
  Material& material = test::add_black(scene);
  material.transmission = {0.5f, 1.0f, 0.0f};
  test::add_square(scene, 1.0f);
  expect_near(upwards(scene), {0.5, 1.0, 0.0});
  scene.materials[0].fresnel_reflection = true;
  expect_near(upwards(scene), 0.96 * glm::dvec3(0.5, 1.0, 0.0));
}

TEST(Transmittance, UnlitGlassIsOpaque) {
  Scene scene;
  scene.materials.push_back(glass());
  scene.materials[0].unlit = true;
  test::add_square(scene, 1.0f);
  EXPECT_EQ(upwards(scene), glm::dvec3(0.0));
}

/// What gets to (0.5, 0.25, 0) on a square, seen from above, from `arrival`.
double red_arriving(const Scene& scene, const LightArrival& arrival) {
  const TracedScene traced = prepare_scene(scene);
  const Ray down{{0.5, 0.25, 2}, {0, 0, -1}};
  const auto hit = closest_hit(traced, down, kNoTriangle);
  if (!hit) return -1.0;
  return visibility(traced, *hit, shading_frame(traced, *hit, down.direction), arrival).x;
}

LightArrival from(const glm::dvec3& way, double distance = kInfinity) {
  return {glm::normalize(way), distance, glm::dvec3(1.0)};
}

TEST(Visibility, ATriangleThatFacesAwayIsDarkUnlessNormalsRoundItOff) {
  Scene scene;
  Material& material = test::add_black(scene);
  material.alpha_mode = AlphaMode::blend;
  Mesh& square = test::add_square(scene, 0.0f);
  EXPECT_EQ(red_arriving(scene, from({1, 0, 0.1})), 1.0);
  EXPECT_EQ(red_arriving(scene, from({1, 0, -0.1})), 0.0) << "flat";
  // The surface is raised by (0, 0, 0.375), half a metre from the rim.
  const float h = std::sqrt(0.5f);
  square.normals = {{-h, 0, h}, {h, 0, h}, {h, 0, h}, {-h, 0, h}};
  EXPECT_EQ(red_arriving(scene, from({1, 0, -0.1})), 1.0) << "over the rim";
  EXPECT_EQ(red_arriving(scene, from({1, 0, -0.7})), 1.0) << "just over the rim";
  EXPECT_EQ(red_arriving(scene, from({1, 0, -0.8})), 0.0) << "through the triangle";
  EXPECT_EQ(red_arriving(scene, from({-1, 0, -0.8})), 0.0) << "through its neighbour";
  EXPECT_EQ(red_arriving(scene, from({3, 0, -1.125}, std::hypot(3, 1.125))), 1.0) << "1.5 down over 3 from up there";
  EXPECT_EQ(red_arriving(scene, from({3, 0, -2.25}, std::hypot(3, 2.25))), 0.0);
  material.base_color.w = 0.25f;
  EXPECT_EQ(red_arriving(scene, from({1, 0, -0.8})), 0.0) << "its own triangle is in the way whatever its alpha";
  test::add_square(scene, 0.25f);
  EXPECT_EQ(red_arriving(scene, from({1, 0, -0.1})), 0.0) << "what is above is behind another surface";
}

}  // namespace
}  // namespace vernier::reference
