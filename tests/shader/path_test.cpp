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

/// Room for the paths of `invocations` with `stack` waiting rays each, and nothing more.
Memory path_memory(uint invocations, uint stack) {
  Memory scene;
  scene.paths.assign(invocations * PATH_WORDS(stack), 0xdeadu);
  return scene;
}

TEST(Path, comes_back_as_it_was_saved_among_others) {
  constexpr uint kInvocations = 5;
  Memory scene = path_memory(kInvocations, 2);
  const BoundMemory bound(scene);
  for (uint i = 0; i < kInvocations; ++i) {
    Path path(PathPlace(i, kInvocations), 70u + i, i % 2 == 0, vec3(1, 2, 3) * float(i), 0u,
              numbered_ray(100.0f * float(i)));
    RayCounts counts{};
    push_ray(path, counts, numbered_ray(1000.0f + 100.0f * float(i)));
    push_ray(path, counts, numbered_ray(2000.0f + 100.0f * float(i)));
    save_path(path);
  }
  EXPECT_EQ(std::count(scene.paths.begin(), scene.paths.end(), 0xdeadu), 0);  // every word has one owner
  for (uint i = 0; i < kInvocations; ++i) {
    Path path = restored_path(PathPlace(i, kInvocations));
    EXPECT_EQ(path.sample_index, 70u + i);
    EXPECT_EQ(path.hit, i % 2 == 0);
    EXPECT_EQ(path.radiance, vec3(1, 2, 3) * float(i));
    expect_equal(path.current, numbered_ray(100.0f * float(i)));
    ASSERT_EQ(path.waiting, 2u);
    expect_equal(pop_ray(path), numbered_ray(2000.0f + 100.0f * float(i)));
    expect_equal(pop_ray(path), numbered_ray(1000.0f + 100.0f * float(i)));
    EXPECT_EQ(path.waiting, 0u);
  }
}

TEST(Path, a_full_stack_drops_and_counts) {
  PATH_STACK_SIZE = 2;
  Memory scene = path_memory(1, 2);
  const BoundMemory bound(scene);
  Path path(PathPlace(0u, 1u), 0u, false, vec3(0), 0u, numbered_ray(0));
  RayCounts counts{};
  for (int i = 0; i < 5; ++i) push_ray(path, counts, numbered_ray(100.0f * float(i)));
  EXPECT_EQ(path.waiting, 2u);
  EXPECT_EQ(counts.dropped, 3u);
  expect_equal(pop_ray(path), numbered_ray(100));
  PATH_STACK_SIZE = 18;
}

TEST(Path, the_deepest_ray_goes_first_and_what_passes_waits_lowest) {
  Memory scene = path_memory(1, 18);
  const BoundMemory bound(scene);
  Path path(PathPlace(0u, 1u), 0u, false, vec3(0), 0u, no_ray());
  RayCounts counts{};
  const Children children(numbered_ray(100), numbered_ray(200), numbered_ray(300));
  ASSERT_TRUE(next_ray(path, children, counts));
  expect_equal(path.current, children.refracted);
  const Children none(no_ray(), no_ray(), no_ray());
  ASSERT_TRUE(next_ray(path, none, counts));
  expect_equal(path.current, children.reflected);
  ASSERT_TRUE(next_ray(path, none, counts));
  expect_equal(path.current, children.passed);
  EXPECT_FALSE(next_ray(path, none, counts));
  EXPECT_EQ(counts.reflection, 1u);
  EXPECT_EQ(counts.refraction, 1u);
}

}  // namespace
}  // namespace vernier::shader
