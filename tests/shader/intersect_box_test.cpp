#include <gtest/gtest.h>

#include <array>

#include "shader/coarse_kernel.h"
#include "shader/random_values.h"
#include "shader/shader.h"

namespace vernier::shader {
namespace {

/// One node of a BVH with four random child boxes.
struct Node {
  vec3 origin;
  uint exponents[3];
  std::array<std::array<uint, 3>, 4> lo, hi;
  uint child_count;
};

Node random_node(RandomValues& random) {
  Node node;
  node.origin = random.in_cube();
  for (uint& exponent : node.exponents) exponent = 115u + random.word() % 5u;  // cells of 2^-12 to 2^-8
  for (int child = 0; child < 4; ++child) {
    for (int axis = 0; axis < 3; ++axis) {
      const uint a = random.word() % 256u, b = random.word() % 256u;
      node.lo[child][axis] = std::min(a, b);
      node.hi[child][axis] = std::max(a, b);
    }
  }
  node.child_count = 1u + random.word() % 4u;
  return node;
}

uint four_bytes(const std::array<std::array<uint, 3>, 4>& bytes, int axis) {
  return bytes[0][axis] | bytes[1][axis] << 8 | bytes[2][axis] << 16 | bytes[3][axis] << 24;
}

ivec4 entries_of(const Node& node, const Ray& ray, float t_min, float t_max) {
  const uvec4 a(floatBitsToUint(node.origin.x), floatBitsToUint(node.origin.y), floatBitsToUint(node.origin.z),
                node.exponents[0] | node.exponents[1] << 8 | node.exponents[2] << 16);
  const uvec4 b(four_bytes(node.lo, 0), four_bytes(node.hi, 0), four_bytes(node.lo, 1), four_bytes(node.hi, 1));
  const uvec4 c(four_bytes(node.lo, 2), four_bytes(node.hi, 2), 0u, node.child_count);
  return intersect_children(slab_ray(ray), a, b, c, t_min, t_max);
}

struct Interval {
  double enter, leave;
};

/// The part of the ray in child `child`'s box, in double; empty where enter > leave.
Interval exact_interval(const Node& node, int child, const Ray& ray, double t_min, double t_max) {
  Interval inside = {t_min, t_max};
  for (int axis = 0; axis < 3; ++axis) {
    const double cell = std::ldexp(1.0, static_cast<int>(node.exponents[axis]) - 127);
    const double lo = node.origin[axis] + node.lo[child][axis] * cell,
                 hi = node.origin[axis] + node.hi[child][axis] * cell;
    const double o = ray.origin[axis], d = ray.direction[axis];
    if (d == 0) {
      if (o < lo || o > hi) return {1, 0};
      continue;
    }
    inside.enter = std::max(inside.enter, std::min((lo - o) / d, (hi - o) / d));
    inside.leave = std::min(inside.leave, std::max((lo - o) / d, (hi - o) / d));
  }
  return inside;
}

Ray random_ray(RandomValues& random, const Node& node, int number) {
  vec3 aim = (random.in_cube() + 1.0f) * 127.5f;
  for (int axis = 0; axis < 3; ++axis) {
    aim[axis] = node.origin[axis] + std::ldexp(aim[axis], static_cast<int>(node.exponents[axis]) - 127);
  }
  const vec3 origin = number % 5 == 0 ? aim : random.in_cube() * 2.0f;
  vec3 direction = number % 5 == 0 ? random.direction() : aim - origin;
  if (number % 3 == 0) direction[number % 9 / 3] = number % 2 == 0 ? 0.0f : -0.0f;
  return Ray(origin, direction);
}

/// With boxes padded for each node, or by one bound of the ray.
class IntersectBoxes : public testing::TestWithParam<bool> {
  CoarseKernel kernel_{GetParam()};
};

INSTANTIATE_TEST_SUITE_P(IntersectBox, IntersectBoxes, testing::Bool(),
                         [](const auto& coarse) { return coarse.param ? "coarse" : "fine"; });

TEST_P(IntersectBoxes, no_box_that_the_ray_meets_is_missed_and_few_others_are_met) {
  RandomValues random(31);
  int met = 0, missed = 0, needless = 0;
  for (int i = 0; i < 200000; ++i) {
    const Node node = random_node(random);
    const Ray ray = random_ray(random, node, i);
    const float t_max = i % 2 == 0 ? LARGEST_FLOAT : random.in(0.1, 2);
    const ivec4 entries = entries_of(node, ray, 0.0f, t_max);
    std::array<bool, 4> reported{};
    for (int k = 0; k < 4; ++k) {
      if (entries[k] != SLAB_MISS) reported[static_cast<std::size_t>(entries[k] & 3)] = true;
    }
    for (int child = 0; child < 4; ++child) {
      const Interval inside = exact_interval(node, child, ray, 0, t_max);
      const bool meets = inside.enter <= inside.leave && static_cast<uint>(child) < node.child_count;
      ASSERT_TRUE(!meets || reported[static_cast<std::size_t>(child)]) << i;
      met += meets ? 1 : 0;
      missed += meets ? 0 : 1;
      needless += !meets && reported[static_cast<std::size_t>(child)] ? 1 : 0;
    }
  }
  EXPECT_GT(met, 30000);
  EXPECT_LT(needless, missed / 1000);  // the padding is some millionths of the box
}

TEST_P(IntersectBoxes, children_come_nearest_first) {
  RandomValues random(32);
  for (int i = 0; i < 100000; ++i) {
    const Node node = random_node(random);
    const Ray ray = random_ray(random, node, i);
    const ivec4 entries = entries_of(node, ray, 0.0f, LARGEST_FLOAT);
    ASSERT_LE(entries.x, entries.y);
    ASSERT_LE(entries.y, entries.z);
    ASSERT_LE(entries.z, entries.w);
    for (int k = 0; k < 4; ++k) {
      if (entries[k] == SLAB_MISS) continue;
      const Interval inside = exact_interval(node, entries[k] & 3, ray, 0, LARGEST_FLOAT);
      const double scale = 1.0 / std::min({glm::length(ray.direction), 1.0f});
      ASSERT_LE(glm::intBitsToFloat(entries[k] & ~3), inside.enter + 1e-6 * scale) << i;
    }
  }
}

TEST(IntersectBox, the_interval_of_t_is_respected) {
  Node node;
  node.origin = vec3(0);
  for (uint& exponent : node.exponents) exponent = 127u;
  for (uint child = 0; child < 4; ++child) {
    node.lo[child] = {10 * child + 10, 0, 0};
    node.hi[child] = {10 * child + 12, 9, 9};
  }
  node.child_count = 4;
  const Ray ray(vec3(0, 5, 5), vec3(1, 0, 0));
  const auto slots = [&](float t_min, float t_max) {
    const ivec4 entries = entries_of(node, ray, t_min, t_max);
    std::string text;
    for (int k = 0; k < 4; ++k) text += entries[k] == SLAB_MISS ? "-" : std::to_string(entries[k] & 3);
    return text;
  };
  EXPECT_EQ(slots(0, 1000), "0123");
  EXPECT_EQ(slots(0, 25), "01--");
  EXPECT_EQ(slots(15, 1000), "123-");
  EXPECT_EQ(slots(21, 31), "12--");
  EXPECT_EQ(slots(13, 19), "----");
  node.child_count = 2;
  EXPECT_EQ(slots(0, 1000), "01--");
}

TEST(IntersectBox, reciprocals_stay_finite_and_keep_their_sign) {
  EXPECT_EQ(bounded_reciprocal(4.0f), 0.25f);
  EXPECT_EQ(bounded_reciprocal(-4.0f), -0.25f);
  EXPECT_EQ(bounded_reciprocal(0.0f), 0x1p80f);
  EXPECT_EQ(bounded_reciprocal(-0.0f), -0x1p80f);
  EXPECT_EQ(bounded_reciprocal(-1e-40f), -0x1p80f);
}

}  // namespace
}  // namespace vernier::shader
