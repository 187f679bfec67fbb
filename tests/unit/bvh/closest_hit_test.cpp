#include "closest_hit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "bvh/build_bvh.h"
#include "triangle_sets.h"

namespace vernier::test {
namespace {

// Rays in all directions from about the scene's box, every other one at a point of a triangle, every fifth along an
// axis; the zero components of the latter are -0 or +0.
TestRay make_ray(const Bvh& bvh, const Triangles& triangles, std::mt19937& random, int number) {
  std::uniform_real_distribution<double> place(-1.5, 1.5);
  const auto point = [&] { return glm::dvec3(place(random), place(random), place(random)); };
  const glm::dvec3 middle = 0.5 * (glm::dvec3(bvh.bounds.lo) + glm::dvec3(bvh.bounds.hi));
  const glm::dvec3 half = 0.5 * (glm::dvec3(bvh.bounds.hi) - glm::dvec3(bvh.bounds.lo));
  const double reach = std::max({half.x, half.y, half.z});
  TestRay ray{middle + reach * point(), point()};
  const BvhTriangle& triangle = triangles[random() % triangles.size()];
  const glm::dvec3 target =
      glm::dvec3(triangle.v0) * 0.25 + glm::dvec3(triangle.v1) * 0.5 + glm::dvec3(triangle.v2) * 0.25;
  if (number % 2 == 0) {
    ray.direction = (target - ray.origin) / reach;
  }
  if (number % 5 == 0) {
    const int axis = number % 3;
    ray.direction = number % 2 == 0 ? glm::dvec3(-0.0) : glm::dvec3(0.0);
    ray.direction[axis] = number % 4 < 2 ? 1.0 : -1.0;
    ray.origin = target;
    ray.origin[axis] = middle[axis] - 2.0 * reach * ray.direction[axis];
  }
  return ray;
}

TEST(ClosestHit, EqualsBruteForceOnEverySet) {
  std::mt19937 random(7);
  for (const auto& [name, triangles] : all_sets()) {
    const Bvh bvh = build_bvh(triangles, {}, 2);
    const int ray_count = static_cast<int>(std::clamp<std::size_t>(2000000 / triangles.size(), 300, 3000));
    int hit_count = 0;
    WalkCounts counts;
    for (int i = 0; i < ray_count; ++i) {
      const TestRay ray = make_ray(bvh, triangles, random, i);
      const TestHit found = closest_hit(bvh, ray, counts);
      ASSERT_EQ(found, closest_hit_by_brute_force(triangles, ray)) << name << ", ray " << i;
      hit_count += found.id != 0xffffffffu;
    }
    // Half the rays are aimed at a triangle, and those at slivers and at flat boxes seen from the side may pass.
    EXPECT_GT(hit_count, ray_count / 20) << name;
    EXPECT_LT(counts.largest_stack, bvh.depth) << name << ": depth - 1 groups must do";
  }
}

TEST(ClosestHit, VisitsFewRecords) {
  const Triangles triangles = spheres_on_ground(40);
  const Bvh bvh = build_bvh(triangles, {}, 2);
  std::mt19937 random(8);
  WalkCounts counts;
  constexpr int kRayCount = 1000;
  for (int i = 0; i < kRayCount; ++i) {
    closest_hit(bvh, make_ray(bvh, triangles, random, i), counts);
  }
  // 88 000 triangles; a random line through the root's box visits about 16 records by the areas of the boxes, before
  // the first hit ends the walk. Twice that leaves room for rays that are aimed.
  EXPECT_LT(static_cast<double>(counts.records) / kRayCount, 32.0);
}

TEST(ClosestHit, MissesAnEmptyTree) {
  WalkCounts counts;
  EXPECT_EQ(closest_hit(build_bvh({}, {}, 1), {{0, 0, 0}, {1, 0, 0}}, counts), TestHit());
}

}  // namespace
}  // namespace vernier::test
