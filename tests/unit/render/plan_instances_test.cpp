#include "render/plan_instances.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "shared/render_constants.h"
#include "unit/reference/test_scenes.h"

namespace vernier {
namespace {

/// A mesh of `triangles` triangles at `copies` places.
void add_copies(Scene& scene, std::size_t triangles, std::size_t copies) {
  Mesh& mesh = test::add_polygon(scene, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  mesh.triangles.assign(triangles, mesh.triangles[0]);
  mesh.triangle_materials.assign(triangles, 0);
  const Instance first = scene.instances.back();
  scene.instances.resize(scene.instances.size() + copies - 1, first);
}

Scene with_material() {
  Scene scene;
  test::add_black(scene);
  return scene;
}

TEST(PlanInstances, few_copies_are_made) {
  Scene scene = with_material();
  add_copies(scene, 1000, 1000);
  const InstancePlan plan = plan_instances(scene);
  EXPECT_TRUE(plan.meshes.empty());
  EXPECT_EQ(plan.triangles, 1'000'000u);
  EXPECT_EQ(plan.stored_triangles, 1'000'000u);
  EXPECT_EQ(plan.stored_vertices, 3000u);
}

TEST(PlanInstances, what_saves_most_is_shared_first) {
  Scene scene = with_material();
  add_copies(scene, 100, 10);
  add_copies(scene, 1'000'000, 3);
  add_copies(scene, 1000, 1);
  const InstancePlan plan = plan_instances(scene);
  EXPECT_EQ(plan.meshes, std::vector<std::uint32_t>{1});
  EXPECT_EQ(plan.triangles, 3'002'000u);
  EXPECT_EQ(plan.stored_triangles, 1'002'000u);
  EXPECT_EQ(plan.shared_instances, 3u);
  for (std::size_t i = 0; i < scene.instances.size(); ++i) EXPECT_EQ(plan.place[i], i >= 10 && i < 13 ? 0u : NONE) << i;
}

TEST(PlanInstances, what_is_smaller_than_an_instance_is_copied) {
  Scene scene = with_material();
  add_copies(scene, 2, 600'000);
  EXPECT_TRUE(plan_instances(scene).meshes.empty());
}

TEST(PlanInstances, tests_may_have_it_their_way) {
  Scene scene = with_material();
  add_copies(scene, 1'000'000, 3);
  add_copies(scene, 2, 1);
  EXPECT_TRUE(plan_instances(scene, Sharing::never).meshes.empty());
  EXPECT_EQ(plan_instances(scene, Sharing::always).meshes, (std::vector<std::uint32_t>{0, 1}));
}

TEST(PlanInstances, what_roundings_would_move_is_copied) {
  Scene scene = with_material();
  add_copies(scene, 2, 4);
  glm::dmat4& sheared = scene.instances[1].world_from_object;
  sheared[1].x = 40.0;
  // Along its own axes: harmless, however it is turned.
  scene.instances[2].world_from_object =
      glm::rotate(glm::dmat4(1.0), 0.7, glm::dvec3(1, 2, 3)) * glm::scale(glm::dmat4(1.0), glm::dvec3(1e4, -1e-4, 1));
  scene.instances[3].world_from_object = glm::dmat4(0x1p-60);
  scene.instances[3].world_from_object[3] = glm::dvec4(0, 0, 0, 1);
  const InstancePlan plan = plan_instances(scene, Sharing::always);
  EXPECT_EQ(plan.place, (std::vector<std::uint32_t>{0, NONE, 0, NONE}));
}

TEST(PlanInstances, roundings_spread_by_shears_and_not_by_scales) {
  EXPECT_EQ(rounding_spread(glm::dmat3(1.0)), 1.0);
  EXPECT_DOUBLE_EQ(rounding_spread(glm::dmat3(glm::dvec3(1e6, 0, 0), glm::dvec3(0, -3, 0), glm::dvec3(0, 0, 1e-9))),
                   1.0);
  const double half = std::sqrt(0.5);
  EXPECT_NEAR(rounding_spread(glm::dmat3(glm::dvec3(half, half, 0), glm::dvec3(-half, half, 0), glm::dvec3(0, 0, 1))),
              2.0, 1e-12);
  EXPECT_EQ(rounding_spread(glm::dmat3(glm::dvec3(1, 0, 0), glm::dvec3(10, 1, 0), glm::dvec3(0, 0, 1))), 21.0);
}

TEST(PlanInstances, a_shared_mesh_has_a_space_of_its_own) {
  Scene scene = with_material();
  Mesh& mesh = test::add_polygon(scene, {{100, -3, 0}, {104, 5, 0}, {102, 0, 1}});
  mesh.positions.push_back({1e9f, 0, 0});  // a vertex of no triangle
  const InstancePlan plan = plan_instances(scene, Sharing::always);
  EXPECT_EQ(plan.spaces[0].center, glm::dvec3(102, 0, 0));
  EXPECT_EQ(plan.spaces[0].metres_per_unit, 8.0);
}

}  // namespace
}  // namespace vernier
