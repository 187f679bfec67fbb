#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "reference/traced_scene.h"
#include "test_scenes.h"

namespace vernier::reference {
namespace {

std::optional<Hit> first_hit(const Scene& scene, glm::dvec3 origin, glm::dvec3 direction,
                             std::uint32_t source = kNoTriangle) {
  return closest_hit(prepare_scene(scene), {origin, glm::normalize(direction)}, source);
}

TEST(ClosestHit, GivesDistanceAndWeights) {
  Scene scene;
  test::add_black(scene);
  test::add_polygon(scene, {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}});
  const auto hit = first_hit(scene, {1, 2, 5}, {0, 0, -1});
  ASSERT_TRUE(hit);
  EXPECT_DOUBLE_EQ(hit->t, 5.0);
  EXPECT_LT(glm::distance(hit->weights, glm::dvec3(0.25, 0.25, 0.5)), 1e-15);
  EXPECT_EQ(hit->coverage, 1.0);
}

TEST(ClosestHit, BothSidesAreHitAndBehindIsNot) {
  Scene scene;
  test::add_black(scene);
  test::add_square(scene, 0.0f);
  EXPECT_TRUE(first_hit(scene, {0.1, 0.2, -3}, {0, 0, 1}));
  EXPECT_FALSE(first_hit(scene, {0.1, 0.2, -3}, {0, 0, -1}));
  EXPECT_FALSE(first_hit(scene, {1.5, 0.2, 3}, {0, 0, -1}));
  EXPECT_FALSE(first_hit(scene, {3, 0.5, 0}, {-1, 0, 0}));  // edge-on
}

TEST(ClosestHit, TiesGoToTheLowestNumber) {
  Scene scene;
  test::add_black(scene);
  for (int copy = 0; copy < 40; ++copy) test::add_square(scene, 1.0f);
  test::add_square(scene, 0.5f);
  for (double y = -0.9; y < 0.9; y += 0.17) {
    const auto hit = first_hit(scene, {0.3, y, 4}, {0.01, 0.02, -1});
    ASSERT_TRUE(hit);
    EXPECT_LT(hit->triangle, 2u);
  }
}

// The higher triangles' box begins nearer to the eye and is walked first; the tie still goes to the lower ones.
TEST(ClosestHit, TiesDoNotDependOnTheWalk) {
  Scene scene;
  test::add_black(scene);
  const auto add_slope = [&](float from, float to) {  // of the plane z = x
    test::add_polygon(scene, {{from, -1, from}, {to, -1, to}, {to, 1, to}, {from, 1, from}});
  };
  add_slope(-0.5f, 0.5f);
  add_slope(-1.0f, 9.0f);
  for (int side : {-20, -20, -20, 20, 20, 20}) add_slope(side - 1.0f, side + 1.0f);
  for (const double x : {-0.4, -0.1, 0.2, 0.3}) {
    const auto hit = first_hit(scene, {x, 0.3, 30}, {0, 0, -1});
    ASSERT_TRUE(hit);
    EXPECT_LT(hit->triangle, 2u);
  }
}

TEST(ClosestHit, TheSharedEdgeBelongsToTheLowerTriangleAndHasNoGap) {
  Scene scene;
  test::add_black(scene);
  test::add_square(scene, 0.0f);
  const TracedScene traced = prepare_scene(scene);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> within(-1.0, 1.0);
  for (int i = 0; i < 20000; ++i) {
    const double along = within(random);
    const glm::dvec3 origin(within(random), within(random), 2.0);
    const Ray ray{origin, glm::normalize(glm::dvec3(along, along, 0) - origin)};
    EXPECT_TRUE(closest_hit(traced, ray, kNoTriangle)) << i;
  }
  EXPECT_EQ(first_hit(scene, {0.25, 0.25, 2}, {0, 0, -1})->triangle, 0u);
}

TEST(ClosestHit, ZeroAreaIsNeverHit) {
  Scene scene;
  test::add_black(scene);
  test::add_polygon(scene, {{-1, 0, 0}, {1, 0, 0}, {1, 0, 0}});
  EXPECT_FALSE(first_hit(scene, {0, 0, 1}, {0, 0, -1}));
  EXPECT_FALSE(first_hit(scene, {-3, 0, 0}, {1, 0, 0}));
}

TEST(ClosestHit, NothingOnThePlaneOfTheOriginIsHit) {
  Scene scene;
  test::add_black(scene);
  test::add_square(scene, 0.3f);
  test::add_square(scene, 0.3f);                        // a coincident twin
  test::add_square(scene, std::nextafter(0.3f, 0.0f));  // the closest that float positions can be
  const double z = 0.3f;
  const auto hit = first_hit(scene, {0.1, 0.2, z}, {0.9, 0.1, -1e-3}, 0);
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->triangle / 2, 2u);
}

// Points computed on triangles far from the origin, in grazing directions: none may meet its own plane again.
TEST(ClosestHit, NoSelfHitsFarOut) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (const float offset : {0.0f, 1e3f, 1e6f}) {
    Scene scene;
    test::add_black(scene);
    const glm::vec3 o(offset, -offset, 0.7f * offset);
    test::add_polygon(scene, {o + glm::vec3(0, 0, 0.2), o + glm::vec3(2, 0.1, 0), o + glm::vec3(0.3, 3, 1)});
    scene.instances.push_back(scene.instances[0]);
    const TracedScene traced = prepare_scene(scene);
    const Triangle& triangle = traced.baked.triangles[0];
    for (int i = 0; i < 2000; ++i) {
      const double b1 = unit(random) * 0.5;
      const double b2 = unit(random) * 0.5;
      const glm::dvec3 along = glm::normalize(triangle.corners[1] - triangle.corners[0]);
      const double tilt = std::pow(10.0, -6.0 * unit(random)) * (i % 2 ? 1.0 : -1.0);
      const Ray ray{triangle.corners[0] + b1 * (triangle.corners[1] - triangle.corners[0]) +
                        b2 * (triangle.corners[2] - triangle.corners[0]),
                    glm::normalize(along + tilt * triangle.normal)};
      EXPECT_FALSE(closest_hit(traced, ray, 0)) << offset << ' ' << i;
    }
  }
}

// The tree against all triangles one by one.
TEST(ClosestHit, TheTreeHidesNothing) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> within(-1.0f, 1.0f);
  const auto point = [&] { return glm::vec3(within(random), within(random), within(random)); };
  Scene scene;
  test::add_black(scene);
  for (int i = 0; i < 300; ++i) {
    const glm::vec3 corner = 3.0f * point();
    test::add_polygon(scene, {corner, corner + point(), corner + point()});
  }
  const TracedScene traced = prepare_scene(scene);
  int hits = 0;
  for (int i = 0; i < 5000; ++i) {
    Ray ray{glm::dvec3(5.0f * point()), glm::normalize(glm::dvec3(point()))};
    if (i % 3 == 0) ray.direction = {0, i % 2 ? 1 : -1, 0};  // along an axis, with zeros
    const ShearedRay sheared(ray, kNoTriangle, traced.baked.largest_coordinate);
    std::optional<Crossing> best;
    std::uint32_t best_id = kNoTriangle;
    for (std::uint32_t id = 0; id < traced.baked.triangles.size(); ++id) {
      const auto crossing = sheared.hit(traced.baked.triangles[id], id);
      if (crossing && (!best || crossing->t < best->t)) {
        best = crossing;
        best_id = id;
      }
    }
    const auto hit = closest_hit(traced, ray, kNoTriangle);
    ASSERT_EQ(hit ? hit->triangle : kNoTriangle, best_id) << i;
    hits += hit.has_value();
  }
  EXPECT_GT(hits, 500);
}

TEST(ClosestHit, AlphaCutsOut) {
  Scene scene;
  Material& front = test::add_black(scene);
  front.alpha_mode = AlphaMode::mask;
  front.base_color.w = 0.49f;
  test::add_square(scene, 1.0f);
  test::add_black(scene).alpha_mode = AlphaMode::blend;
  scene.materials[1].base_color.w = 0.0f;
  test::add_square(scene, 0.5f);
  test::add_black(scene).alpha_mode = AlphaMode::blend;
  scene.materials[2].base_color.w = 0.25f;
  test::add_square(scene, 0.0f);
  const auto hit = first_hit(scene, {0.1, 0.2, 3}, {0, 0, -1});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->triangle / 2, 2u);
  EXPECT_DOUBLE_EQ(hit->coverage, 0.25);
  scene.materials[0].base_color.w = 0.5f;  // at the cutoff: a hit, and a whole one
  EXPECT_EQ(first_hit(scene, {0.1, 0.2, 3}, {0, 0, -1})->triangle / 2, 0u);
  EXPECT_EQ(first_hit(scene, {0.1, 0.2, 3}, {0, 0, -1})->coverage, 1.0);
}

TEST(ClosestHit, AlphaComesFromVerticesAndTextures) {
  Scene scene;
  Material& material = test::add_black(scene);
  material.alpha_mode = AlphaMode::blend;
  material.base_color.w = 0.5f;
  test::add_square(scene, 0.0f).colors.assign(4, glm::vec4(1, 1, 1, 0.5f));
  const int texture = test::add_texture(scene, test::linear_texels(1, 1, {0x66000033u}));  // r 0.2, a 0.4
  const auto alpha = [&] { return first_hit(scene, {0.1, 0.2, 3}, {0, 0, -1})->coverage; };
  EXPECT_DOUBLE_EQ(alpha(), 0.25);
  scene.materials[0].textures[TEXTURE_SLOT_ALPHA].texture = texture;
  scene.materials[0].textures[TEXTURE_SLOT_BASE_COLOR].texture = texture;
  EXPECT_DOUBLE_EQ(alpha(), 0.25 * 0.2);  // blinn: map_d
  scene.materials[0].workflow = Workflow::metallic_roughness;
  EXPECT_DOUBLE_EQ(alpha(), 0.25 * 0.4);
}

TEST(ClosestHit, EmptySceneIsMissed) {
  EXPECT_FALSE(first_hit(Scene{}, {0, 0, 0}, {0, 0, -1}));
}

}  // namespace
}  // namespace vernier::reference
