#include "reference/radiance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "reference/fresnel.h"
#include "test_scenes.h"

namespace vernier::reference {
namespace {

constexpr double kPi = std::numbers::pi;

void expect_near(const glm::dvec3& a, const glm::dvec3& b, double bound = 1e-7) {
  EXPECT_LT(glm::distance(a, b), bound) << a.x << ' ' << a.y << ' ' << a.z;
}

glm::dvec3 seen(const Scene& scene, glm::dvec3 origin, glm::dvec3 direction, PathLimits limits = {}) {
  return radiance(prepare_scene(scene), limits, {origin, glm::normalize(direction)}).radiance;
}

Material glass() {
  Material material;
  material.roughness = 0.0f;
  material.transmission = glm::vec3(1.0f);
  material.thin_walled = false;
  return material;
}

TEST(Radiance, DiffusePlaneUnderAPointLight) {
  Scene scene;
  test::add_black(scene).base_color = {0.5f, 0.25f, 1.0f, 1.0f};
  test::add_square(scene, 0.0f, 5.0f);
  scene.lights.push_back(Light{});
  scene.lights[0].position = {0, 0, 2};
  scene.lights[0].intensity = glm::vec3(10.0f);
  // At (1.5, 0, 0): d = 2.5, cosine 0.8.
  const double irradiance = 10.0 / 6.25 * 0.8;
  expect_near(seen(scene, {1.5, 0, 3}, {0, 0, -1}), glm::dvec3(0.5, 0.25, 1.0) * irradiance / kPi);
  expect_near(seen(scene, {1.5, 0, -3}, {0, 0, 1}), glm::dvec3(0.0));  // the other side is dark
}

TEST(Radiance, BlinnHighlight) {
  Scene scene;
  Material& material = test::add_black(scene);
  material.specular = glm::vec3(1.0f);
  material.exponent = 8.0f;
  test::add_square(scene, 0.0f, 5.0f);
  scene.lights.push_back(Light{});
  scene.lights[0].kind = LightKind::directional;
  scene.lights[0].direction = {0, -0.6, -0.8};
  // H lies half way between (0, 0.6, 0.8) and (0, 0, 1): cos^2 = (1 + 0.8) / 2.
  expect_near(seen(scene, {0.1, 0.2, 3}, {0, 0, -1}), glm::dvec3(std::pow(0.9, 4.0) / kPi));
  scene.materials[0].exponent = 0.0f;
  expect_near(seen(scene, {0.1, 0.2, 3}, {0, 0, -1}), glm::dvec3(1.0 / kPi));
}

TEST(Radiance, ShadowOfABlocker) {
  Scene scene;
  test::add_black(scene).base_color = glm::vec4(1.0f);
  test::add_square(scene, 0.0f, 5.0f);
  test::add_square(scene, 1.0f, 0.5f);
  scene.lights.push_back(Light{});
  scene.lights[0].position = {0, 0, 2};
  // The shadow reaches to 1.
  EXPECT_EQ(seen(scene, {0.99, 0, 0.5}, {0, 0, -1}), glm::dvec3(0.0));
  EXPECT_GT(seen(scene, {1.01, 0, 0.5}, {0, 0, -1}).x, 0.01);
}

TEST(Radiance, EmissionAndAmbient) {
  Scene scene;
  Material& material = test::add_black(scene);
  material.emission = {1.0f, 2.0f, 3.0f};
  material.ambient = glm::vec3(0.5f);
  test::add_square(scene, 0.0f);
  scene.environment.sky = glm::vec3(6.0f);
  scene.environment.ground = glm::vec3(0.0f);
  expect_near(seen(scene, {0.1, 0.2, 3}, {0, 0, -1}), {2.5, 3.5, 4.5});  // A = 3 for a horizontal normal
}

// Two mirrors that face each other; after k reflections the black rest of the weight ends the ray.
TEST(Radiance, ParallelMirrorsGiveAGeometricSeries) {
  Scene scene;
  Material& material = test::add_black(scene);
  material.reflection = glm::vec3(0.5f);
  material.emission = glm::vec3(1.0f);
  test::add_square(scene, -1.0f, 100.0f);
  test::add_square(scene, 1.0f, 100.0f);
  for (const std::uint32_t bounces : {0u, 1u, 5u, 20u}) {
    const double expected = (1.0 - std::pow(0.5, bounces + 1.0)) / 0.5;
    expect_near(seen(scene, {0.1, 0.2, 0}, {0.01, 0, -1}, {bounces, 0.0}), glm::dvec3(expected), 1e-14);
  }
  scene.materials[0].reflection = glm::vec3(0x0.ffcp0f);
  constexpr double kReflectance = 1.0 - 0x1p-10;
  const double deep = (1.0 - std::pow(kReflectance, 1001.0)) * 0x1p10;
  expect_near(seen(scene, {0.1, 0.2, 0}, {0, 0, -1}, {1000, 0.0}), glm::dvec3(deep), 1e-11 * deep);
  scene.materials[0].reflection = glm::vec3(0.5f);
  // Weights 1, 1/2, 1/4, 1/8 are traced, 1/16 is below the cutoff; a weight at the cutoff is not.
  expect_near(seen(scene, {0.1, 0.2, 0}, {0.01, 0, -1}, {50, 0.1}), glm::dvec3(1.875), 1e-14);
  expect_near(seen(scene, {0.1, 0.2, 0}, {0.01, 0, -1}, {50, 0.125}), glm::dvec3(1.875), 1e-14);
}

TEST(Radiance, SchlickMirrorAtGrazing) {
  Scene scene;
  Material& material = test::add_black(scene);
  material.reflection = glm::vec3(0.2f);
  material.fresnel_reflection = true;
  test::add_square(scene, 0.0f, 50.0f);
  scene.environment.sky = scene.environment.ground = glm::vec3(1.0f);
  const double cosine = 0.25;
  const glm::dvec3 direction(std::sqrt(1.0 - cosine * cosine), 0, -cosine);
  expect_near(seen(scene, {0, 0, 1}, direction), glm::dvec3(0.2 + 0.8 * std::pow(0.75, 5.0)));
}

// A slab of glass: the ray leaves parallel to how it came, shifted by thickness x (tan i - tan t).
TEST(Radiance, SlabShiftsTheRayBySnell) {
  const double sine = 0.6;
  const double thickness = 2.0;
  const double shift_to = 3.0 * 0.75 + thickness * (sine / 1.5) / std::sqrt(1.0 - 0.16) + 4.0 * 0.75;
  const double t = 1.0 - fresnel_reflectance(0.8, 1.5);
  for (const double aside : {-1e-6, 1e-6}) {  // the edge between two colours lies exactly where the ray must land
    Scene scene;
    scene.materials.push_back(glass());
    test::add_box(scene, {-100, -100, -2}, {100, 100, 0});
    test::add_black(scene).emission = {1.0f, 0.0f, 0.0f};
    test::add_polygon(scene, {{-100, -100, -6}, {0, -100, -6}, {0, 100, -6}, {-100, 100, -6}});
    test::add_black(scene).emission = {0.0f, 1.0f, 0.0f};
    test::add_polygon(scene, {{0, -100, -6}, {100, -100, -6}, {100, 100, -6}, {0, 100, -6}});
    // Two bounces: in and out; the cutoff drops the weak echoes inside.
    const glm::dvec3 color = seen(scene, {aside - shift_to, 0.3, 3}, {sine, 0, -0.8}, {2, 0.5});
    expect_near(color, aside < 0.0 ? glm::dvec3(t * t, 0, 0) : glm::dvec3(0, t * t, 0));
  }
}

TEST(Radiance, GlassInAUniformWorldIsInvisible) {
  Scene scene;
  scene.materials.push_back(glass());
  test::add_box(scene, {-1, -1, -1}, {1, 1, 1});
  scene.environment.sky = scene.environment.ground = glm::vec3(1.0f);
  const glm::dvec3 eyes[] = {{3, 0.4, 0.3}, {2, 2.5, 3}, {-1.5, 4, 0.1}};
  for (const glm::dvec3& eye : eyes)
    expect_near(seen(scene, eye, glm::dvec3(0.13, 0.21, -0.07) - eye, {100, 0.0}), glm::dvec3(1.0), 1e-12);
}

TEST(Radiance, TotalReflectionKeepsTheLightInside) {
  Scene scene;
  scene.materials.push_back(glass());
  // From the back, at 60 degrees, all is mirrored to the emitter on the same side.
  test::add_square(scene, 0.0f, 50.0f);
  test::add_black(scene).emission = glm::vec3(1.0f);
  test::add_square(scene, -1.0f, 50.0f);
  scene.environment.sky = scene.environment.ground = glm::vec3(5.0f);
  expect_near(seen(scene, {0, 0, -0.5}, {std::sqrt(3.0), 0, 1}), glm::dvec3(1.0), 1e-12);
}

TEST(Radiance, AbsorptionInsideFollowsBeer) {
  Scene scene;
  Material body = glass();
  body.ior = 1.0f;  // no reflection, no bend
  body.absorption = {1.0f, 0.5f, 0.0f};
  scene.materials.push_back(body);
  test::add_box(scene, {-1, -1, -1}, {1, 1, 1});
  test::add_black(scene).emission = glm::vec3(1.0f);  // beyond the body, where nothing absorbs
  test::add_square(scene, -5.0f);
  expect_near(seen(scene, {0.1, 0.2, 4}, {0, 0, -1}), glm::exp(glm::dvec3(-2.0, -1.0, 0.0)));
}

TEST(Radiance, ThinGlassGoesStraightThrough) {
  Scene scene;
  scene.materials.push_back(glass());
  scene.materials[0].thin_walled = true;
  scene.materials[0].base_color = {1.0f, 0.5f, 0.25f, 1.0f};
  scene.materials[0].absorption = glm::vec3(9.0f);
  test::add_square(scene, 0.0f);
  scene.environment.sky = scene.environment.ground = glm::vec3(1.0f);
  for (const double side : {1.0, -1.0})
    expect_near(seen(scene, {0.1, 0.2, 4 * side}, {0, 0, -side}), 0.04 + 0.96 * glm::dvec3(1, 0.5, 0.25));
}

TEST(Radiance, PlainMtlGlassSplitsByItsReflection) {
  Scene scene;
  Material& material = test::add_black(scene);
  material.reflection = glm::vec3(0.25f);
  material.transmission = {1.0f, 0.5f, 0.0f};
  test::add_square(scene, 0.0f);
  test::add_black(scene).emission = glm::vec3(2.0f);
  test::add_square(scene, -1.0f);
  scene.environment.sky = scene.environment.ground = glm::vec3(1.0f);
  expect_near(seen(scene, {0.1, 0.2, 4}, {0, 0, -1}), 0.25 + 0.75 * 2.0 * glm::dvec3(1, 0.5, 0));
}

TEST(Radiance, ThreeBlendedLayers) {
  Scene scene;
  const glm::vec3 colors[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (int layer = 0; layer < 3; ++layer) {
    Material& material = test::add_black(scene);
    material.emission = colors[layer];
    material.alpha_mode = AlphaMode::blend;
    material.base_color.w = 0.5f;
    test::add_square(scene, -static_cast<float>(layer));
  }
  scene.environment.sky = scene.environment.ground = glm::vec3(8.0f);
  expect_near(seen(scene, {0.1, 0.2, 4}, {0, 0, -1}, {0, 0.0}), glm::dvec3(0.5, 0.25, 0.125) + 1.0, 1e-12);
  // The last layer has weight 1/4, what lies beyond it 1/8.
  expect_near(seen(scene, {0.1, 0.2, 4}, {0, 0, -1}, {0, 0.2}), {0.5, 0.25, 0.125}, 1e-12);
}

TEST(Radiance, BlendedCoincidentLayersShowTheFirstOnly) {
  Scene scene;
  for (int layer = 0; layer < 2; ++layer) {
    Material& material = test::add_black(scene);
    material.emission = layer == 0 ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
    material.alpha_mode = AlphaMode::blend;
    material.base_color.w = 0.5f;
    test::add_square(scene, 0.3f);
  }
  // In exact arithmetic the ray goes on at t > 0 and the twin lies at t = 0.
  expect_near(seen(scene, {0.1, 0.2, 4}, {0.1, 0.2, -1}), {0.5, 0.0, 0.0}, 1e-12);
}

TEST(Radiance, BlendWeighsReflections) {
  Scene scene;
  Material& material = test::add_black(scene);
  material.reflection = glm::vec3(1.0f);
  material.alpha_mode = AlphaMode::blend;
  material.base_color.w = 0.25f;
  test::add_square(scene, 0.0f);
  scene.environment.sky = glm::vec3(2.0f);
  scene.environment.ground = glm::vec3(0.0f);
  // Looking 30 degrees down at a wall: both rays see the environment at d.y = -1/2.
  expect_near(seen(scene, {0, 0.1, 0.3}, {0, -0.5, -std::sqrt(0.75)}), glm::dvec3(0.5), 1e-12);
}

TEST(Radiance, UnlitShowsItsBaseOnly) {
  Scene scene;
  Material material;
  material.unlit = true;
  material.roughness = 0.0f;
  material.emission = glm::vec3(1.0f);
  material.base_color = {0.25f, 0.5f, 0.75f, 1.0f};
  scene.materials.push_back(material);
  test::add_square(scene, 0.0f);
  scene.environment.sky = scene.environment.ground = glm::vec3(8.0f);
  scene.lights.push_back(Light{});
  expect_near(seen(scene, {0.1, 0.2, 4}, {0, 0, -1}), {0.25, 0.5, 0.75}, 1e-15);
}

// A shading normal that sends the mirror ray below the triangle: it is folded up at the triangle's plane.
TEST(Radiance, MirrorRaysStayOutside) {
  Scene scene;
  Material& material = test::add_black(scene);
  material.reflection = glm::vec3(1.0f);
  test::add_square(scene, 0.0f).normals.assign(4, glm::vec3(0.8f, 0, 0.6f));
  test::add_black(scene).emission = glm::vec3(1.0f);
  test::add_square(scene, -1.0f, 50.0f);
  test::add_black(scene).emission = {0.0f, 3.0f, 0.0f};
  test::add_square(scene, 9.0f, 500.0f);
  expect_near(seen(scene, {-0.5, 0.2, 0.5}, {0.8, 0, -0.6}), {0, 3, 0}, 1e-12);
}

TEST(Radiance, MissSaysSo) {
  Scene scene;
  scene.environment.sky = scene.environment.ground = glm::vec3(0.5f);
  const Arrival arrival = radiance(prepare_scene(scene), {}, {{0, 0, 0}, {0, 0, -1}});
  EXPECT_FALSE(arrival.hit);
  EXPECT_EQ(arrival.radiance, glm::dvec3(0.5));
}

}  // namespace
}  // namespace vernier::reference
