#include <gtest/gtest.h>

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>

#include "shader/instanced_kernel.h"
#include "shader/random_values.h"
#include "shader/tiny_scene.h"
#include "unit/bvh/triangle_sets.h"

namespace vernier::shader {
namespace {

TEST(InstanceStack, groups_that_do_not_fit_come_back_in_their_own_tree) {
  // Smaller and smaller triangles in a row, from the smallest of which all others wait, in meshes that cross each
  // other.
  Scene scene;
  test::add_black(scene);
  test::add_square(scene, -3.0f, 8.0f);
  Mesh row;
  for (const BvhTriangle& t : test::geometric_series()) {
    if (t.id >= 64) break;
    const auto first = static_cast<std::uint32_t>(row.positions.size());
    row.positions.insert(row.positions.end(), {t.v0, t.v1, t.v2});
    row.triangles.emplace_back(first, first + 1, first + 2);
  }
  row.triangle_materials.assign(row.triangles.size(), 0);
  scene.meshes.push_back(row);
  for (int i = 0; i < 12; ++i) {
    Instance instance{.name = "", .mesh = static_cast<std::uint32_t>(scene.meshes.size() - 1)};
    instance.world_from_object = glm::scale(glm::dmat4(1.0), glm::dvec3(1.0 + 0.01 * i));
    scene.instances.push_back(instance);
  }
  const PackedScene packed = pack_scene(scene, 1, BuildMethod::standard, Sharing::always);
  Memory memory = memory_of(packed);
  const BoundMemory bound(memory);
  const InstancedKernel kernel;
  RandomValues random(17);
  std::ptrdiff_t most_waiting = 0;
  COUNT_COST = true;
  for (int i = 0; i < 2000; ++i) {
    const float start = std::ldexp(1.0f, -20 - static_cast<int>(random.word() % 40));
    const Ray ray(vec3(start, 0, 0), vec3(1, random.in(-0.05, 0.3), random.in(-0.05, 0.3)));
    for (uint& group : traversal_groups) group = 0u;
    SHIFT_STACK = false;
    const Found in_array = traverse_bvh(Search(ray, 0.0f, NONE, LARGEST_FLOAT, i % 4 == 0));
    SHIFT_STACK = true;
    const Found shifted = traverse_bvh(Search(ray, 0.0f, NONE, LARGEST_FLOAT, i % 4 == 0));
    SHIFT_STACK = false;
    most_waiting =
        std::max(most_waiting, std::ranges::count_if(traversal_groups, [](uint group) { return group != 0u; }));
    ASSERT_TRUE(in_array.finished && shifted.finished);
    ASSERT_EQ(in_array.hit.triangle, shifted.hit.triangle) << i;
    ASSERT_EQ(in_array.hit.instance, shifted.hit.instance) << i;
    ASSERT_EQ(in_array.nodes, shifted.nodes) << i;
    ASSERT_EQ(in_array.triangles, shifted.triangles) << i;
  }
  COUNT_COST = false;
  EXPECT_GT(most_waiting, std::ptrdiff_t{SHIFTED_GROUPS} + 4);
}

}  // namespace
}  // namespace vernier::shader
