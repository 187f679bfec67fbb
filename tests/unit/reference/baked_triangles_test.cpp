#include "reference/baked_triangles.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "test_scenes.h"

namespace vernier::reference {
namespace {

TEST(BakeTriangles, NumbersInstancesThenTriangles) {
  Scene scene;
  test::add_black(scene);
  test::add_square(scene, 0.0f);
  test::add_square(scene, 1.0f);
  scene.instances.push_back({"", 0, glm::translate(glm::dmat4(1.0), glm::dvec3(0, 0, 5))});
  const BakedTriangles baked = bake_triangles(scene);
  ASSERT_EQ(baked.triangles.size(), 6u);
  EXPECT_EQ(baked.triangles[3].instance, 1u);
  EXPECT_EQ(baked.triangles[3].primitive, 1u);
  EXPECT_EQ(baked.triangles[4].instance, 2u);
  EXPECT_EQ(baked.triangles[4].corners[0], glm::dvec3(-1, -1, 5));
  EXPECT_EQ(baked.largest_coordinate, 5.0);
}

TEST(BakeTriangles, MirroringKeepsTheFrontOutside) {
  Scene scene;
  test::add_black(scene);
  test::add_square(scene, 0.0f);
  scene.instances[0].world_from_object = glm::scale(glm::dmat4(1.0), glm::dvec3(-2, 1, 1));
  const BakedTriangles baked = bake_triangles(scene);
  EXPECT_EQ(baked.triangles[0].normal, glm::dvec3(0, 0, 1));
  EXPECT_EQ(baked.triangles[0].vertices, glm::uvec3(0, 2, 1));
  EXPECT_EQ(baked.triangles[0].corners[2], glm::dvec3(-2, -1, 0));
  EXPECT_EQ(baked.frames[0].handedness, -1.0);
}

TEST(BakeTriangles, ZeroAreaHasNoNormal) {
  Scene scene;
  test::add_black(scene);
  test::add_polygon(scene, {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}});
  test::add_polygon(scene, {{1e-20f, 0, 0}, {0, 1e-20f, 0}, {0, 0, 0}});
  const BakedTriangles baked = bake_triangles(scene);
  EXPECT_EQ(baked.triangles[0].normal, glm::dvec3(0.0));
  EXPECT_EQ(baked.triangles[1].normal, glm::dvec3(0, 0, 1));  // small is not zero
}

TEST(BakeTriangles, EmptySceneIsEmpty) {
  EXPECT_TRUE(bake_triangles(Scene{}).triangles.empty());
}

}  // namespace
}  // namespace vernier::reference
