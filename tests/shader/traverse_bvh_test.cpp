#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "shader/bound_bvh.h"
#include "shader/random_values.h"
#include "shader/shader.h"
#include "unit/bvh/triangle_sets.h"

namespace vernier::shader {
namespace {

using test::Triangles;

constexpr int kRays = 2000;

/// The sets scaled as choose_traced_space does: the largest coordinate in (1/2, 1].
std::vector<test::NamedSet> traced_sets() {
  std::vector<test::NamedSet> sets = test::all_sets();
  for (test::NamedSet& set : sets) {
    // Triangles below an ulp of their distance from the ray degenerate to noise in the ray's frame and may seem hit
    // from anywhere. The boxes keep such rays off, every triangle in turn does not.
    if (set.name == "geometric series") set.triangles.resize(16);
    float largest = 0.0f;
    for (const BvhTriangle& t : set.triangles) {
      for (const vec3& v : {t.v0, t.v1, t.v2}) largest = std::max(largest, max3(abs(v)));
    }
    const int exponent = -static_cast<int>(std::ceil(std::log2(largest)));
    for (BvhTriangle& t : set.triangles) {
      for (vec3* v : {&t.v0, &t.v1, &t.v2}) {
        for (int axis = 0; axis < 3; ++axis) (*v)[axis] = std::ldexp((*v)[axis], exponent);
      }
    }
  }
  return sets;
}

/// Every triangle in turn with the same test.
Hit brute_force(const Triangles& triangles, const Ray& ray, float t_min, uint after, float t_max) {
  Hit hit = no_hit(t_max);
  const ShearedRay sheared = sheared_ray(ray);
  for (const BvhTriangle& t : triangles) intersect_triangle(sheared, t.v0, t.v1, t.v2, t.id, 0u, t_min, after, hit);
  return hit;
}

Hit closest(const Ray& ray, float t_min = 0.0f, uint after = NONE, float t_max = LARGEST_FLOAT) {
  const Found found = traverse_bvh(Search(ray, t_min, after, t_max, false));
  EXPECT_TRUE(found.finished);
  return found.hit;
}

/// A ray through the bounds of `triangles`; every fourth is parallel to an axis or a plane, every eighth has a -0.
Ray random_ray(RandomValues& random, const Triangles& triangles, int number) {
  const BvhTriangle& target = triangles[random.word() % triangles.size()];
  const BvhTriangle& far = triangles[random.word() % triangles.size()];
  const float reach = glm::distance(far.v1, target.v0) + glm::distance(target.v1, target.v2);
  vec3 origin = far.v1 + random.direction() * (reach * random.in(0, 1));
  const float b = random.in(0, 1);
  const vec3 aim = target.v0 + (target.v1 - target.v0) * b + (target.v2 - target.v0) * ((1 - b) * random.in(0, 1));
  vec3 direction = aim - origin;
  if (number % 4 == 0) {
    const std::uint32_t axis = random.word() % 3;
    direction[static_cast<int>(axis)] = number % 8 == 0 ? -0.0f : 0.0f;
    origin[static_cast<int>(axis)] = aim[static_cast<int>(axis)];
  }
  return Ray(origin, direction);
}

TEST(TraverseBvh, finds_what_every_triangle_in_turn_finds) {
  for (const auto& [name, triangles] : traced_sets()) {
    Memory scene = bvh_memory(triangles);
    const BoundMemory bound(scene);
    RandomValues random(25);
    int hits = 0;
    for (int i = 0; i < kRays; ++i) {
      const Ray ray = random_ray(random, triangles, i);
      const Hit expected = brute_force(triangles, ray, 0.0f, NONE, LARGEST_FLOAT);
      const Hit hit = closest(ray);
      ASSERT_EQ(hit.triangle, expected.triangle) << name << ' ' << i;
      ASSERT_EQ(hit.t, expected.t) << name << ' ' << i;
      hits += hit.triangle != NONE ? 1 : 0;
    }
    EXPECT_GT(hits, kRays / 10) << name;
  }
}

TEST(TraverseBvh, all_hits_come_one_after_the_other) {
  for (const auto& [name, triangles] : traced_sets()) {
    Memory scene = bvh_memory(triangles);
    const BoundMemory bound(scene);
    RandomValues random(26);
    for (int i = 0; i < 100; ++i) {
      const Ray ray = random_ray(random, triangles, i);
      float t = 0.0f;
      uint after = NONE;
      for (int step = 0; step < 20; ++step) {
        const Hit expected = brute_force(triangles, ray, t, after, LARGEST_FLOAT);
        const Hit hit = closest(ray, t, after);
        ASSERT_EQ(hit.triangle, expected.triangle) << name << ' ' << i;
        if (hit.triangle == NONE) break;
        ASSERT_TRUE(hit.t > t || (hit.t == t && hit.triangle > after));
        t = hit.t;
        after = hit.triangle;
      }
    }
  }
}

TEST(TraverseBvh, any_hit_is_some_opaque_hit_within_reach) {
  const Triangles triangles = test::random_soup(2000, 0.1f, 27);
  const auto not_opaque = [](std::uint32_t id) { return id % 3 == 0; };
  Memory scene = bvh_memory(triangles, not_opaque);
  const BoundMemory bound(scene);
  RandomValues random(28);
  for (int i = 0; i < kRays; ++i) {
    const Ray ray = random_ray(random, triangles, i);
    const float t_max = random.in(0.2, 1.2);
    const Found found = traverse_bvh(Search(ray, 0.0f, NONE, t_max, true));
    const Hit hit = found.hit;
    EXPECT_TRUE(found.finished);
    Hit opaque = no_hit(t_max);
    const ShearedRay sheared = sheared_ray(ray);
    for (const BvhTriangle& t : triangles) {
      if (!not_opaque(t.id)) intersect_triangle(sheared, t.v0, t.v1, t.v2, t.id, 0u, 0.0f, NONE, opaque);
    }
    if (opaque.triangle != NONE) {
      ASSERT_NE(hit.triangle, NONE);
      ASSERT_EQ(found.is_opaque, !not_opaque(hit.triangle));
    } else {
      ASSERT_FALSE(found.is_opaque);
      // Only what lets light pass is there: the closest of it comes back.
      ASSERT_EQ(hit.triangle, brute_force(triangles, ray, 0.0f, NONE, t_max).triangle);
    }
    ASSERT_TRUE(hit.triangle == NONE || hit.t < t_max);
  }
}

TEST(TraverseBvh, both_stacks_take_the_same_steps) {
  int compared = 0;
  for (const auto& [name, triangles] : traced_sets()) {
    if (build_bvh(triangles, {}, 1).depth > SHIFT_STACK_MAX_SIZE)
      continue;  // the host takes the array there (specialize)
    Memory scene = bvh_memory(triangles);
    const BoundMemory bound(scene);
    RandomValues random(29);
    COUNT_COST = true;
    for (int i = 0; i < kRays / 4; ++i) {
      const Ray ray = random_ray(random, triangles, i);
      Found found[2];
      for (int shift = 0; shift < 2; ++shift) {
        SHIFT_STACK = shift == 1;
        found[shift] = traverse_bvh(Search(ray, 0.0f, NONE, LARGEST_FLOAT, false));
      }
      ASSERT_EQ(found[0].hit.triangle, found[1].hit.triangle) << name;
      ASSERT_EQ(found[0].hit.t, found[1].hit.t);
      ASSERT_EQ(found[0].nodes, found[1].nodes);
      ASSERT_EQ(found[0].triangles, found[1].triangles);
      ASSERT_GE(found[0].nodes, 1u) << name;
    }
    COUNT_COST = false;
    SHIFT_STACK = false;
    ++compared;
  }
  EXPECT_GE(compared, 5);
}

TEST(TraverseBvh, groups_that_do_not_fit_are_moved_and_come_back) {
  // From the smallest triangle on, all larger ones wait.
  Triangles triangles = test::geometric_series();
  triangles.resize(64);
  ASSERT_LE(build_bvh(triangles, {}, 1).depth, SHIFT_STACK_MAX_SIZE);
  Memory scene = bvh_memory(triangles);
  const BoundMemory bound(scene);
  RandomValues random(31);
  std::ptrdiff_t most_waiting = 0;
  COUNT_COST = true;
  for (int i = 0; i < kRays; ++i) {
    const Ray ray(vec3(std::ldexp(1.0f, -66), 0, 0), vec3(1, random.in(0, 0.3), random.in(0, 0.3)));
    const bool any = i % 2 == 0;
    for (uint& group : traversal_groups) group = 0u;
    SHIFT_STACK = false;
    const Found in_array = traverse_bvh(Search(ray, 0.0f, NONE, LARGEST_FLOAT, any));
    SHIFT_STACK = true;
    const Found shifted = traverse_bvh(Search(ray, 0.0f, NONE, LARGEST_FLOAT, any));
    SHIFT_STACK = false;
    most_waiting =
        std::max(most_waiting, std::ranges::count_if(traversal_groups, [](uint group) { return group != 0u; }));
    ASSERT_EQ(in_array.hit.triangle, shifted.hit.triangle) << i;
    ASSERT_EQ(in_array.nodes, shifted.nodes) << i;
    ASSERT_EQ(in_array.triangles, shifted.triangles) << i;
    ASSERT_TRUE(in_array.finished && shifted.finished);
  }
  COUNT_COST = false;
  EXPECT_GT(most_waiting, 2 * std::ptrdiff_t{SHIFTED_GROUPS});
}

TEST(TraverseBvh, rays_that_are_none_end_at_once) {
  const Triangles triangles = test::random_soup(500, 0.3f, 30);
  Memory scene = bvh_memory(triangles);
  const BoundMemory bound(scene);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  for (float bad : {nan, infinity, -infinity}) {
    for (int axis = 0; axis < 3; ++axis) {
      Ray ray(vec3(0.5f), vec3(1));
      ray.origin[axis] = bad;
      EXPECT_EQ(closest(ray).triangle, NONE);
      ray = Ray(vec3(0.5f), vec3(1));
      ray.direction[axis] = bad;
      EXPECT_EQ(closest(ray).triangle, NONE);
    }
  }
  EXPECT_EQ(closest(Ray(vec3(0.5f), vec3(0.0f))).triangle, NONE);
  EXPECT_EQ(closest(Ray(vec3(0.5f), vec3(-0.0f))).triangle, NONE);
}

TEST(TraverseBvh, an_empty_scene_is_missed) {
  Memory scene = bvh_memory(Triangles{});
  const BoundMemory bound(scene);
  EXPECT_EQ(closest(Ray(vec3(0), vec3(1))).triangle, NONE);
}

TEST(TraverseBvh, groups_hold_three_siblings) {
  const uint group = group_of_rest(ivec4(4 * 9 + 3, 4 * 10 + 2, 4 * 11 + 0, 4 * 12 + 1), 0xabcdefu);
  EXPECT_EQ(group_count(group), 3u);
  EXPECT_EQ(group_next(group), 0xabcdefu + 2u);
  const uint second = without_next(group);
  EXPECT_EQ(group_count(second), 2u);
  EXPECT_EQ(group_next(second), 0xabcdefu);
  const uint last = without_next(second);
  EXPECT_EQ(group_next(last), 0xabcdefu + 1u);
  EXPECT_EQ(group_count(without_next(last)), 0u);
  EXPECT_EQ(group_count(group_of_rest(ivec4(8, 12, SLAB_MISS, SLAB_MISS), 5u)), 1u);
}

}  // namespace
}  // namespace vernier::shader
