#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <optional>

#include "shader/random_values.h"
#include "shader/shader.h"

namespace vernier::shader {
namespace {

struct Triangle {
  vec3 v0, v1, v2;
};

Hit hit_of(const Ray& ray, const Triangle& t, uint id = 7u, float t_min = 0.0f, uint after = NONE) {
  Hit hit = no_hit(LARGEST_FLOAT);
  intersect_triangle(sheared_ray(ray), t.v0, t.v1, t.v2, id, 70u, t_min, after, hit);
  return hit;
}

// What spans_zero and is_of_one_sign do with bits, by floats.
TEST(IntersectTriangle, signs_by_bits_are_those_by_floats) {
  constexpr float kValues[] = {0.0f, -0.0f, 1.0f, -1.0f, 1e-45f, -1e-45f, 3e38f, -3e38f};
  for (const float a : kValues) {
    for (const float b : kValues) {
      for (const float c : kValues) {
        const float least = std::min({a, b, c}), most = std::max({a, b, c});
        EXPECT_EQ(spans_zero(a, b, c), least <= 0.0f && most >= 0.0f) << a << ' ' << b << ' ' << c;
        EXPECT_EQ(is_of_one_sign(vec3(a, b, c)), least >= 0.0f || most <= 0.0f) << a << ' ' << b << ' ' << c;
      }
    }
  }
}

vec3 weights_of(const Ray& ray, const Triangle& t) {
  return crossing_weights(ray, t.v0, t.v1, t.v2);
}

/// Where the ray meets the plane of the triangle, in double: t and the weights of the corners.
struct ExpectedCrossing {
  double t, b0, b1, b2;
};

ExpectedCrossing exact_crossing(const Ray& ray, const Triangle& triangle) {
  const glm::dvec3 o(ray.origin), d(ray.direction), v0(triangle.v0), v1(triangle.v1), v2(triangle.v2);
  const glm::dvec3 normal = glm::cross(v1 - v0, v2 - v0);
  const double t = glm::dot(normal, v0 - o) / glm::dot(normal, d);
  const glm::dvec3 p = o + d * t;
  const double area = glm::dot(normal, normal);
  return {t, glm::dot(glm::cross(v2 - v1, p - v1), normal) / area, glm::dot(glm::cross(v0 - v2, p - v2), normal) / area,
          glm::dot(glm::cross(v1 - v0, p - v0), normal) / area};
}

const Triangle kUnit = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
const Ray kDown(vec3(0.25f, 0.5f, 2), vec3(0, 0, -1));

TEST(IntersectTriangle, by_hand) {
  const Hit hit = hit_of(kDown, kUnit);
  EXPECT_EQ(hit.t, 2.0f);
  EXPECT_EQ(hit.triangle, 7u);
  EXPECT_EQ(hit.record, 70u);
  EXPECT_EQ(weights_of(kDown, kUnit), vec3(0.25f, 0.25f, 0.5f));
  // Back side, long direction, axis x.
  EXPECT_EQ(hit_of(Ray(vec3(0.25f, 0.5f, -2), vec3(0, 0, 4)), kUnit).t, 0.5f);
  const Triangle sideways = {{0, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  EXPECT_EQ(weights_of(Ray(vec3(-1, 0.25f, 0.5f), vec3(1, 0, 0)), sideways).z, 0.5f);
}

TEST(IntersectTriangle, misses_leave_the_hit_alone) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  EXPECT_EQ(hit_of(Ray(vec3(0.75f, 0.5f, 2), vec3(0, 0, -1)), kUnit).triangle, NONE);
  EXPECT_EQ(hit_of(Ray(vec3(0.25f, 0.5f, 2), vec3(0, 0, 1)), kUnit).triangle, NONE);  // behind
  EXPECT_EQ(hit_of(Ray(vec3(-1, 0.5f, 0), vec3(1, 0, 0)), kUnit).triangle, NONE);     // edge on
  EXPECT_EQ(hit_of(kDown, {{0, 0, 0}, {1, 1, 0}, {2, 2, 0}}).triangle, NONE);         // no area
  EXPECT_EQ(hit_of(kDown, {{nan, 0, 0}, {1, 0, 0}, {0, 1, 0}}).triangle, NONE);
  EXPECT_EQ(hit_of(Ray(vec3(nan, 0.5f, 2), vec3(0, 0, -1)), kUnit).triangle, NONE);
  EXPECT_EQ(hit_of(Ray(vec3(0.25f, 0.5f, infinity), vec3(0, 0, -1)), kUnit).triangle, NONE);
  EXPECT_EQ(hit_of(Ray(vec3(0.25f, 0.5f, 2), vec3(nan, 0, -1)), kUnit).triangle, NONE);
  EXPECT_EQ(hit_of(Ray(vec3(0.25f, 0.5f, 2), vec3(0)), kUnit).triangle, NONE);
  EXPECT_EQ(hit_of(kDown, kUnit, 7u, 2.5f).t, LARGEST_FLOAT);
}

TEST(IntersectTriangle, hits_are_ordered_by_distance_and_number) {
  Hit hit = no_hit(LARGEST_FLOAT);
  const ShearedRay ray = sheared_ray(kDown);
  EXPECT_TRUE(intersect_triangle(ray, kUnit.v0, kUnit.v1, kUnit.v2, 9u, 0u, 0.0f, NONE, hit));
  EXPECT_FALSE(intersect_triangle(ray, kUnit.v0, kUnit.v1, kUnit.v2, 12u, 1u, 0.0f, NONE, hit));
  EXPECT_EQ(hit.triangle, 9u);
  EXPECT_TRUE(intersect_triangle(ray, kUnit.v0, kUnit.v1, kUnit.v2, 3u, 2u, 0.0f, NONE, hit));
  EXPECT_EQ(hit.triangle, 3u);
  EXPECT_EQ(hit.record, 2u);
  const vec3 up(0, 0, 1);
  EXPECT_TRUE(intersect_triangle(ray, kUnit.v0 + up, kUnit.v1 + up, kUnit.v2 + up, 99u, 3u, 0.0f, NONE, hit));
  EXPECT_EQ(hit.t, 1.0f);
}

TEST(IntersectTriangle, the_search_goes_on_after_a_hit) {
  // At t_min itself only what has a higher number comes after.
  EXPECT_EQ(hit_of(kDown, kUnit, 7u, 2.0f, 6u).triangle, 7u);
  EXPECT_EQ(hit_of(kDown, kUnit, 7u, 2.0f, 7u).triangle, NONE);
  EXPECT_EQ(hit_of(kDown, kUnit, 7u, 2.0f, 8u).triangle, NONE);
  EXPECT_EQ(hit_of(kDown, kUnit, 7u, 2.0f, NONE).triangle, NONE);
  EXPECT_EQ(hit_of(kDown, kUnit, 7u, std::nextafter(2.0f, 0.0f), 8u).triangle, 7u);
}

TEST(IntersectTriangle, agrees_with_double_away_from_the_edges) {
  RandomValues random(18);
  int hits = 0;
  for (int i = 0; i < 300000; ++i) {
    const Triangle triangle = {random.in_cube(), random.in_cube(), random.in_cube()};
    const Ray ray(random.in_cube() * 2.0f, random.direction());
    const ExpectedCrossing exact = exact_crossing(ray, triangle);
    const glm::dvec3 normal = glm::cross(glm::dvec3(triangle.v1 - triangle.v0), glm::dvec3(triangle.v2 - triangle.v0));
    const double slope = std::abs(glm::dot(normal, glm::dvec3(ray.direction)));
    if (slope < 0.05) continue;  // needles and grazing rays: the decision may hang on the last bit
    const double inner = std::min({exact.b0, exact.b1, exact.b2});
    // Coordinates up to 4 in the ray's frame: edge values are off by 2^-24 times some tens.
    const double doubtful = 1e-5 / slope;
    const Hit hit = hit_of(ray, triangle);
    if (inner < -doubtful || exact.t < -doubtful) {
      ASSERT_EQ(hit.triangle, NONE);
    } else if (inner > doubtful && exact.t > doubtful) {
      ASSERT_EQ(hit.triangle, 7u);
      ASSERT_NEAR(hit.t, exact.t, doubtful);
      const vec3 weights = weights_of(ray, triangle);
      ASSERT_NEAR(weights.y, exact.b1, doubtful);
      ASSERT_NEAR(weights.z, exact.b2, doubtful);
      ++hits;
    }
  }
  EXPECT_GT(hits, 1000);
}

TEST(IntersectTriangle, a_hit_in_the_origin_s_own_plane_is_none) {
  // Origins on the triangle as floats round them: whatever t comes out, it is within its own error bound.
  RandomValues random(19);
  for (int i = 0; i < 100000; ++i) {
    const Triangle triangle = {random.in_cube(), random.in_cube(), random.in_cube()};
    const Ray away(triangle.v0, random.direction());
    const Hit hit = hit_of(away, triangle);
    if (hit.triangle == NONE) continue;
    ASSERT_GT(hit.t, 0.0f);
    ASSERT_GT(exact_crossing(away, triangle).t, -1e-30);
  }
}

TEST(IntersectTriangle, neighbours_share_their_edge) {
  // The quad 0 1 2 3 cut along 0-2: a ray at any point of the cut hits one of the halves, whatever the corners' order.
  RandomValues random(20);
  for (int i = 0; i < 200000; ++i) {
    // Convex from wherever it is seen, so that the halves lie on both sides of the cut.
    vec3 corner[4] = {vec3(0), vec3(3, 0, 0), vec3(3, 3, 0), vec3(0, 3, 0)};
    for (vec3& place : corner) place += random.in_cube() * 0.4f;
    const vec3 origin = random.in_cube() * 1.5f + vec3(1.5f, 1.5f, 10);
    const vec3 aim = corner[0] + (corner[2] - corner[0]) * random.in(0.01, 0.99);
    const Ray ray(origin, aim - origin);
    const Hit one = hit_of(ray, {corner[0], corner[1], corner[2]});
    const Hit other = hit_of(ray, {corner[2], corner[3], corner[0]});
    ASSERT_TRUE(one.triangle != NONE || other.triangle != NONE) << i;
  }
}

}  // namespace
}  // namespace vernier::shader
