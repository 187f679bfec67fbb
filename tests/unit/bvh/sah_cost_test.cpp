#include <gtest/gtest.h>

#include "bvh/build_bvh.h"
#include "bvh/zero_area.h"
#include "naive_tree.h"
#include "triangle_sets.h"

namespace vernier::test {
namespace {

// An empty box that grows its neighbours instead of leaving them alone makes the tree twice as dear while every picture
// stays right: only the cost shows it.
TEST(SahCost, IsWithinFivePercentOfANaiveBuilder) {
  for (const auto& [name, triangles] :
       {NamedSet{"soup", random_soup(3000, 0.05f, 1)}, NamedSet{"large triangles", random_soup(1000, 1.0f, 2)},
        NamedSet{"slivers", slivers(2000, 4)}, NamedSet{"grid", flat_grid(40)}, NamedSet{"stairs", stairs(300)},
        NamedSet{"spheres", spheres_on_ground(16)}}) {
    Triangles with_area;
    for (const BvhTriangle& triangle : triangles) {
      if (!has_zero_area(triangle.v0, triangle.v1, triangle.v2)) {
        add(with_area, triangle.v0, triangle.v1, triangle.v2);
      }
    }
    const double naive = naive_sah_cost(with_area);
    const double ours = build_bvh(triangles, {}, 2).sah_cost;
    EXPECT_LT(ours, 1.05 * naive) << name;
    EXPECT_GT(ours, 0.8 * naive) << name << ": too good to be counted right";
    RecordProperty(name, std::to_string(ours / naive));
  }
}

TEST(SahCost, OfOneAndTwoTrianglesIsAsWorkedByHand) {
  Triangles triangles;
  add(triangles, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  // The root is a leaf: area 1 times (1 + 1 triangle).
  EXPECT_DOUBLE_EQ(build_bvh(triangles, {}, 1).sah_cost, 2.0);
  add(triangles, {0, 0, 1}, {1, 0, 1}, {0, 1, 1});
  // The root's box is a unit cube, half area 3; the leaves are unit squares, half area 1, which count twice.
  EXPECT_DOUBLE_EQ(build_bvh(triangles, {}, 1).sah_cost, 1.0 + 2.0 * 2.0 / 3.0);
}

TEST(SahCost, IsTheSameAtEveryScale) {
  const Triangles triangles = random_soup(2000, 0.05f, 9);
  const double cost = build_bvh(triangles, {}, 1).sah_cost;
  EXPECT_DOUBLE_EQ(build_bvh(scaled(triangles, 0x1p90f), {}, 1).sah_cost, cost);
  EXPECT_DOUBLE_EQ(build_bvh(scaled(triangles, 0x1p-80f), {}, 1).sah_cost, cost);
}

}  // namespace
}  // namespace vernier::test
