#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "shader/random_values.h"
#include "shader/shader.h"

namespace vernier::shader {
namespace {

using Wide = __float128;
using glm::dvec3;

/// The levels of all spots, put back to robust at the end.
class LevelScope {
 public:
  explicit LevelScope(uint level) { LEVELS = LEVELS_OF(level); }
  ~LevelScope() { LEVELS = LEVELS_OF(LEVEL_ROBUST); }
};

struct Triangle {
  vec3 v0, v1, v2;
};

/// A closed, star-shaped surface around the origin: `rows` x `columns` corners of radius 1 to 6, as in the catalogue.
std::vector<Triangle> bumpy_sphere(int rows, int columns, RandomValues& random) {
  std::vector<vec3> corners;
  for (int row = 0; row <= rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const bool pole = row == 0 || row == rows;
      if (pole && column > 0) {
        corners.push_back(corners[corners.size() - 1]);
        continue;
      }
      const double theta = M_PI * row / rows, phi = 2 * M_PI * column / columns;
      const double radius = 1.0 + 5.0 * random.uniform(0, 1);
      corners.emplace_back(dvec3(std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi)) *
                           radius);
    }
  }
  std::vector<Triangle> triangles;
  const auto corner = [&](int row, int column) { return corners[row * columns + column % columns]; };
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const vec3 a = corner(row, column), b = corner(row, column + 1);
      const vec3 c = corner(row + 1, column), d = corner(row + 1, column + 1);
      if (a != b) triangles.push_back({a, b, c});
      if (c != d) triangles.push_back({b, d, c});
    }
  }
  return triangles;
}

int hit_count(const std::vector<Triangle>& triangles, const Ray& ray) {
  const ShearedRay sheared = sheared_ray(ray);
  int count = 0;
  for (const Triangle& t : triangles) {
    Hit hit = no_hit(LARGEST_FLOAT);
    count += intersect_triangle(sheared, t.v0, t.v1, t.v2, 0u, 0u, 0.0f, NONE, hit) ? 1 : 0;
  }
  return count;
}

struct Counts {
  int missed = 0;
  int even = 0;  // not 0
};

/// Rays from near the middle of a bumpy sphere, aimed at edges, or at corners: each crosses the closed surface an odd
/// number of times.
Counts aimed_counts(bool at_corners, int ray_count) {
  RandomValues random(7);
  const std::vector<Triangle> triangles = bumpy_sphere(16, 16, random);
  Counts counts;
  for (int i = 0; i < ray_count; ++i) {
    const Triangle& t = triangles[random.word() % triangles.size()];
    const vec3 aim = at_corners ? t.v0 : t.v0 + (t.v1 - t.v0) * random.in(0, 1);
    const vec3 origin = random.in_cube() * 0.3f;
    const int count = hit_count(triangles, Ray(origin, aim - origin));
    counts.missed += count == 0 ? 1 : 0;
    counts.even += count != 0 && count % 2 == 0 ? 1 : 0;
  }
  return counts;
}

TEST(AccuracyLevels, fast_leaks_robust_does_not_exact_counts_right) {
  constexpr int kRays = 20000;
  for (const bool at_corners : {false, true}) {
    {
      const LevelScope fast(LEVEL_FAST);
      EXPECT_GT(aimed_counts(at_corners, kRays).missed, kRays / 100);
    }
    const Counts robust = aimed_counts(at_corners, kRays);
    EXPECT_EQ(robust.missed, 0);
    EXPECT_GT(robust.even, kRays / 100);
    const LevelScope exact(LEVEL_EXACT);
    const Counts exact_counts = aimed_counts(at_corners, kRays);
    EXPECT_EQ(exact_counts.missed, 0);
    EXPECT_EQ(exact_counts.even, 0);
  }
}

TEST(AccuracyLevels, a_ray_through_the_hub_of_a_fan_hits_one_of_its_triangles) {
  const LevelScope exact(LEVEL_EXACT);
  for (const int blades : {3, 4, 7, 64, 1024}) {
    std::vector<Triangle> fan;
    for (int i = 0; i < blades; ++i) {
      const auto rim = [&](int k) {
        const double angle = 2 * M_PI * (k % blades) / blades;
        return vec3(dvec3(std::cos(angle), std::sin(angle), 0.25));
      };
      fan.push_back({vec3(0.0f), rim(i), rim(i + 1)});
    }
    EXPECT_EQ(hit_count(fan, Ray(vec3(0, 0, 3), vec3(0, 0, -1))), 1) << blades;
    EXPECT_EQ(hit_count(fan, Ray(vec3(0, 0, -3), vec3(0, 0, 1))), 1) << blades;
  }
}

struct WideCrossing {
  Wide t, b1, b2;
};

WideCrossing wide_crossing(const Ray& ray, const Triangle& triangle) {
  using V = std::array<Wide, 3>;
  const auto wide = [](const vec3& v) { return V{v.x, v.y, v.z}; };
  const auto minus = [](const V& a, const V& b) { return V{a[0] - b[0], a[1] - b[1], a[2] - b[2]}; };
  const auto dot = [](const V& a, const V& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
  const auto cross = [](const V& a, const V& b) {
    return V{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  };
  const V v0 = wide(triangle.v0), e1 = minus(wide(triangle.v1), v0), e2 = minus(wide(triangle.v2), v0);
  const V d = wide(ray.direction), p = cross(d, e2), s = minus(wide(ray.origin), v0), q = cross(s, e1);
  const Wide det = dot(e1, p);
  return {dot(e2, q) / det, dot(s, p) / det, dot(d, q) / det};
}

double ulps(float found, Wide exact) {
  const double size = std::abs(static_cast<double>(exact));
  return std::abs(static_cast<double>(Wide(found) - exact)) / std::ldexp(1.0, std::ilogb(size) - 23);
}

TEST(AccuracyLevels, exact_crossings_are_right_to_the_last_place_from_any_distance) {
  RandomValues random(9);
  double worst_t = 0, worst_place = 0;
  int tested = 0;
  while (tested < 20000) {
    const Triangle triangle{random.in_cube(), random.in_cube(), random.in_cube()};
    const vec3 aim = triangle.v0 + (triangle.v1 - triangle.v0) * 0.3f + (triangle.v2 - triangle.v0) * 0.4f;
    const vec3 origin = random.direction() * random.power_of_ten(-1, 6);
    const Ray ray(origin, aim - origin);
    const dvec3 e1 = dvec3(triangle.v1 - triangle.v0), e2 = dvec3(triangle.v2 - triangle.v0), n = glm::cross(e1, e2);
    // Slivers and grazing rays are ill-conditioned.
    if (glm::length(n) < 0.05 * glm::length(e1) * glm::length(e2)) continue;
    if (!(std::abs(glm::dot(glm::normalize(n), glm::normalize(dvec3(ray.direction)))) > 0.05)) continue;
    const WideCrossing expected = wide_crossing(ray, triangle);
    // From afar the rounding of the direction leads some rays past the triangle.
    if (expected.b1 < 0 || expected.b2 < 0 || expected.b1 + expected.b2 > 1) continue;
    ++tested;
    const ExactCrossing found = exact_crossing(ray, triangle.v0, triangle.v1, triangle.v2);
    worst_t = std::max(worst_t, ulps(found.t, expected.t));
    for (int axis = 0; axis < 3; ++axis) {
      const Wide place = Wide(triangle.v0[axis]) + expected.b1 * (Wide(triangle.v1[axis]) - triangle.v0[axis]) +
                         expected.b2 * (Wide(triangle.v2[axis]) - triangle.v0[axis]);
      // Rounding to float; beside it wide arithmetic leaves some 2^-44 of the distance.
      const double bound = 0x1p-24 * std::abs(static_cast<double>(place)) + 0x1p-44 * glm::length(dvec3(ray.direction));
      worst_place = std::max(worst_place, std::abs(static_cast<double>(Wide(found.position[axis]) - place)) / bound);
    }
  }
  // Half an ulp is the rounding to float; the quotient of two dot products before it is right to some 2^-44.
  EXPECT_LE(worst_t, 0.5 + 0x1p-10);
  EXPECT_LE(worst_place, 1.0);
  EXPECT_GT(worst_place, 0.1);  // the bound is no larger than it must be
}

TEST(AccuracyLevels, exact_spawned_rays_hit_neither_their_triangle_nor_far_off) {
  const LevelScope exact(LEVEL_EXACT);
  RandomValues random(11);
  int self_hits = 0;
  double largest_offset = 0;
  for (int i = 0; i < 100000; ++i) {
    const vec3 place = random.in_cube() * random.power_of_ten(0, 5);
    const Triangle t{place + random.in_cube(), place + random.in_cube(), place + random.in_cube()};
    const vec3 aim = t.v0 + (t.v1 - t.v0) * random.in(0, 0.5) + (t.v2 - t.v0) * random.in(0, 0.5);
    const vec3 origin = aim + random.direction() * 3.0f;
    const Ray ray(origin, aim - origin);
    Hit hit = no_hit(LARGEST_FLOAT);
    if (!intersect_triangle(sheared_ray(ray), t.v0, t.v1, t.v2, 0u, 0u, 0.0f, NONE, hit)) continue;
    const TrianglePoint point = point_on_triangle(ray, hit, t.v0, t.v1, t.v2, uvec4(0u));
    SurfacePoint surface;
    surface.position = point.position;
    surface.position_error = point.position_error;
    const vec3 normal = unit_vector(cross_product(point.e1, point.e2));
    surface.geometric_normal = dot_product(normal, ray.direction) <= 0.0f ? normal : -normal;
    const vec3 direction = random.direction();
    const Ray spawned(spawn_origin(surface, direction), direction);
    Hit again = no_hit(LARGEST_FLOAT);
    self_hits += intersect_triangle(sheared_ray(spawned), t.v0, t.v1, t.v2, 0u, 0u, 0.0f, NONE, again) ? 1 : 0;
    const float largest = std::max({max3(abs(t.v0)), max3(abs(t.v1)), max3(abs(t.v2))});
    const double ulp = std::ldexp(1.0, std::ilogb(largest) - 23);
    largest_offset = std::max(largest_offset, glm::distance(dvec3(spawned.origin), dvec3(point.position)) / ulp);
  }
  EXPECT_EQ(self_hits, 0);
  EXPECT_LE(largest_offset, 4.0 * std::sqrt(3.0));  // 4 per axis
}

TEST(AccuracyLevels, exact_fresnel_is_right_everywhere_and_the_textbook_is_not) {
  const auto oracle = [](float cosine, float eta) {
    const long double c = cosine, n = eta, k = (n - 1) * (n + 1), g = std::sqrt(k + c * c);
    const long double across = (c - g) / (c + g), along = (n * n * c - g) / (n * n * c + g);
    return 0.5L * (across * across + along * along);
  };
  RandomValues random(13);
  double exact_error = 0, sum_error = 0, textbook_error = 0;
  for (int i = 0; i < 100000; ++i) {
    const float eta =
        i % 2 ? random.power_of_ten(-1, 1) : 1.0f + (random.word() & 1u ? 1 : -1) * random.power_of_ten(-7, -2);
    const float cosine = random.power_of_ten(-8, 0);
    if ((static_cast<long double>(eta) - 1) * (static_cast<long double>(eta) + 1) +
            static_cast<long double>(cosine) * cosine <=
        0) {
      EXPECT_EQ(exact_fresnel(cosine, eta).reflected, 1.0f);
      continue;
    }
    const double expected = static_cast<double>(oracle(cosine, eta));
    const Fresnel exact = exact_fresnel(cosine, eta);
    exact_error = std::max(exact_error, std::abs(exact.reflected - expected));
    sum_error = std::max(sum_error, std::abs(double(exact.reflected) + double(exact.transmitted) - 1.0));
    textbook_error = std::max(textbook_error, std::abs(textbook_fresnel(cosine, eta).reflected - expected));
  }
  // Targets of the exact level: two roundings to float.
  EXPECT_LE(exact_error, 1e-7);
  EXPECT_LE(sum_error, 1e-7);
  EXPECT_GT(textbook_error, 1e-2);
}

TEST(AccuracyLevels, sums_of_the_fast_level_stall_where_the_others_are_exact) {
  const auto sum_of = [](int count) {
    PixelSum sum{};
    for (int i = 0; i < count; ++i) add_sample(sum, vec3(1.0f), true, 0u);
    return sum.red;
  };
  constexpr int kBeyondTheMantissa = (1 << 24) + 100;
  {
    const LevelScope fast(LEVEL_FAST);
    const WideSum red = sum_of(kBeyondTheMantissa);
    EXPECT_EQ(red.high, FILM_PLAIN_SUM);
    EXPECT_EQ(uintBitsToFloat(red.low), 0x1p24f);
  }
  const WideSum red = sum_of(kBeyondTheMantissa);
  EXPECT_EQ(std::ldexp(red.middle, 32) + std::ldexp(red.high, 64), std::ldexp(kBeyondTheMantissa, FILM_FRACTION_BITS));
}

}  // namespace
}  // namespace vernier::shader
