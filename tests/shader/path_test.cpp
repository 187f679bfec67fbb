#include <gtest/gtest.h>

#include <algorithm>

#include "shader/shader.h"

namespace vernier::shader {
namespace {

PathRay numbered_ray(float first) {
  const auto word = [&](int i) { return static_cast<uint>(first) + static_cast<uint>(i); };
  return PathRay(vec3(first, first + 1, first + 2), vec3(first + 3, first + 4, first + 5),
                 vec3(first + 6, first + 7, first + 8), first + 9, word(10), word(11), word(12));
}

void expect_equal(const PathRay& a, const PathRay& b) {
  EXPECT_EQ(a.origin, b.origin);
  EXPECT_EQ(a.direction, b.direction);
  EXPECT_EQ(a.weight, b.weight);
  EXPECT_EQ(a.t_min, b.t_min);
  EXPECT_EQ(a.after_triangle, b.after_triangle);
  EXPECT_EQ(a.depth, b.depth);
  EXPECT_EQ(a.medium, b.medium);
}

/// Room for the paths of `invocations` with PATH_STACK_SIZE waiting rays each, and nothing more.
Memory path_memory(uint invocations) {
  Memory scene;
  scene.paths.assign(invocations * PATH_BLOCKS(PATH_STACK_SIZE), uvec4(0xdeadu));
  return scene;
}

LightVisit numbered_visit(float first) {
  const auto word = [&](int i) { return static_cast<uint>(first) + static_cast<uint>(i); };
  const auto vector = [&](float i) { return vec3(first + i, first + i + 1, first + i + 2); };
  return LightVisit(Hit(first, word(1), word(2), word(4)), word(5), Ray(vector(6), vector(9)), first + 12, word(13),
                    first + 14, vector(15), vector(18));
}

void expect_equal(const LightVisit& a, const LightVisit& b) {
  EXPECT_EQ(a.hit.t, b.hit.t);
  EXPECT_EQ(a.hit.triangle, b.hit.triangle);
  EXPECT_EQ(a.hit.record, b.hit.record);
  EXPECT_EQ(a.hit.instance, b.hit.instance);
  EXPECT_EQ(a.next_light, b.next_light);
  EXPECT_EQ(a.ray.origin, b.ray.origin);
  EXPECT_EQ(a.ray.direction, b.ray.direction);
  EXPECT_EQ(a.t_min, b.t_min);
  EXPECT_EQ(a.after_triangle, b.after_triangle);
  EXPECT_EQ(a.t_max, b.t_max);
  EXPECT_EQ(a.value, b.value);
  EXPECT_EQ(a.optical_depth, b.optical_depth);
}

TEST(Path, comes_back_as_it_was_saved_among_others) {
  constexpr uint kInvocations = 5;
  PATH_STACK_SIZE = 2;
  INSTANCED = true;
  Memory scene = path_memory(kInvocations);
  const BoundMemory bound(scene);
  for (uint i = 0; i < kInvocations; ++i) {
    const float number = 100.0f * float(i);
    Path path(70u + i, i % 2 == 0, vec3(1, 2, 3) * float(i), 0u, PHASE_SHADOW, SampleCost(i, 10 + i, 20 + i),
              numbered_ray(number), numbered_visit(3000.0f + number));
    RayCounts counts{};
    push_ray(path_place(i), path, counts, numbered_ray(1000.0f + number));
    push_ray(path_place(i), path, counts, numbered_ray(2000.0f + number));
    save_path(path_place(i), path);
  }
  EXPECT_EQ(std::count(scene.paths.begin(), scene.paths.end(), uvec4(0xdeadu)), 0);  // every block has one owner
  for (uint i = 0; i < kInvocations; ++i) {
    const float number = 100.0f * float(i);
    Path path = restored_path(path_place(i));
    EXPECT_EQ(path.job, 70u + i);
    EXPECT_EQ(path.hit, i % 2 == 0);
    EXPECT_EQ(path.radiance, vec3(1, 2, 3) * float(i));
    EXPECT_EQ(path.phase, PHASE_SHADOW);
    EXPECT_EQ(path.cost.rays, i);
    EXPECT_EQ(path.cost.nodes, 10 + i);
    EXPECT_EQ(path.cost.triangles, 20 + i);
    expect_equal(path.current, numbered_ray(number));
    expect_equal(path.visit, numbered_visit(3000.0f + number));
    ASSERT_EQ(path.waiting, 2u);
    expect_equal(pop_ray(path_place(i), path), numbered_ray(2000.0f + number));
    expect_equal(pop_ray(path_place(i), path), numbered_ray(1000.0f + number));
    EXPECT_EQ(path.waiting, 0u);
  }
  PATH_STACK_SIZE = 18;
  INSTANCED = false;
}

TEST(Path, a_full_stack_drops_and_counts) {
  PATH_STACK_SIZE = 2;
  Memory scene = path_memory(1);
  const BoundMemory bound(scene);
  Path path = no_path();
  RayCounts counts{};
  for (int i = 0; i < 5; ++i) push_ray(0u, path, counts, numbered_ray(100.0f * float(i)));
  EXPECT_EQ(path.waiting, 2u);
  EXPECT_EQ(counts.dropped, 3u);
  expect_equal(pop_ray(0u, path), numbered_ray(100));
  PATH_STACK_SIZE = 18;
}

TEST(Path, the_deepest_ray_goes_first_and_what_passes_waits_lowest) {
  Memory scene = path_memory(1);
  const BoundMemory bound(scene);
  Path path = no_path();
  RayCounts counts{};
  const Children children(numbered_ray(100), numbered_ray(200), numbered_ray(300));
  ASSERT_TRUE(next_ray(0u, path, children, counts));
  expect_equal(path.current, children.refracted);
  const Children none(no_ray(), no_ray(), no_ray());
  ASSERT_TRUE(next_ray(0u, path, none, counts));
  expect_equal(path.current, children.reflected);
  ASSERT_TRUE(next_ray(0u, path, none, counts));
  expect_equal(path.current, children.passed);
  EXPECT_FALSE(next_ray(0u, path, none, counts));
  EXPECT_EQ(counts.reflection, 1u);
  EXPECT_EQ(counts.refraction, 1u);
}

}  // namespace
}  // namespace vernier::shader
