#include "bvh/coarse.h"

#include <gtest/gtest.h>

#include "bvh/build_bvh.h"
#include "bvh/instance_tree.h"
#include "triangle_sets.h"

namespace vernier::test {
namespace {

bool is_coarse_tree(const Triangles& triangles) {
  return build_bvh(triangles, {}, 2).coarse;
}

/// `count` tiny triangles beside a grid of 512.
Triangles grid_and_specks(int count) {
  Triangles triangles = flat_grid(16);
  for (int i = 0; i < count; ++i) add(triangles, {0, 0.5f, 0}, {1e-5f, 0.5f, 0}, {0, 0.5f, 1e-5f});
  return triangles;
}

TEST(Coarse, trees_of_large_triangles_in_the_unit_cube) {
  EXPECT_TRUE(is_coarse_tree(flat_grid(16)));
  EXPECT_TRUE(is_coarse_tree(scaled(flat_grid(16), -1.0f)));
  EXPECT_FALSE(is_coarse_tree(scaled(flat_grid(16), 1.5f))) << "rays count on a plane's place";
  EXPECT_FALSE(is_coarse_tree(scaled(flat_grid(16), -1.5f)));
  EXPECT_FALSE(is_coarse_tree(scaled(flat_grid(16), 1e-3f))) << "rays would meet many triangles beside theirs";
}

TEST(Coarse, few_triangles_may_be_small) {
  EXPECT_TRUE(is_coarse_tree(grid_and_specks(2)));
  EXPECT_FALSE(is_coarse_tree(grid_and_specks(3))) << "1 in 171";
}

TEST(Coarse, is_so_on_both_levels) {
  const auto coarse_with = [](const Triangles& own, const Triangles& shared) {
    std::vector<ObjectTree> objects = {{build_bvh(shared, {}, 1), static_cast<std::uint32_t>(own.size())}};
    const std::vector<std::uint32_t> numbers(own.size(), 7);
    const std::vector<TreeInstance> instances = {{{glm::vec3(-1.0f), glm::vec3(-0.5f)}, 0, 1}};
    return build_instance_tree(own, numbers, instances, objects, {}, 1).coarse;
  };
  EXPECT_TRUE(coarse_with(flat_grid(8), flat_grid(16)));
  EXPECT_FALSE(coarse_with(flat_grid(8), scaled(flat_grid(16), 1e-3f)));
  EXPECT_FALSE(coarse_with(scaled(flat_grid(8), 1e-3f), flat_grid(16)));
}

}  // namespace
}  // namespace vernier::test
