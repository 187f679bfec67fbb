#include <gtest/gtest.h>

#include "shader/random_values.h"
#include "shader/shader.h"

namespace vernier::shader {
namespace {

/// A point of a triangle as surface_point gives it, without vertex data.
struct Spot {
  vec3 v0, v1, v2;
  SurfacePoint surface;
};

/// A random point of a random triangle: corners `size` apart around a place within `distance`.
Spot random_spot(RandomValues& random, float size, float distance) {
  Spot spot;
  const vec3 place = random.in_cube() * distance;
  spot.v0 = place + random.in_cube() * size;
  spot.v1 = place + random.in_cube() * size;
  spot.v2 = place + random.in_cube() * size;
  float b1 = random.in(0, 1), b2 = random.in(0, 1);
  if (b1 + b2 > 1) b1 = 1 - b1, b2 = 1 - b2;
  if (random.word() % 4 == 0) b2 = 0.0f;  // on an edge
  const TrianglePoint point = weighted_point(spot.v0, spot.v1, spot.v2, uvec4(0u), vec3(1 - b1 - b2, b1, b2), 1.0f);
  const DeviceMaterial plain{};
  spot.surface = surface_point(point, plain, no_slot_texels(), random.direction());
  return spot;
}

bool hits_itself(const Spot& spot, const vec3& direction) {
  const Ray ray(spawn_origin(spot.surface, direction), direction);
  Hit hit = no_hit(LARGEST_FLOAT);
  return intersect_triangle(sheared_ray(ray), spot.v0, spot.v1, spot.v2, 0u, 0u, 0.0f, NONE, hit);
}

/// Self hits of `count` random directions with triangles of 10^[lo, hi) at distances up to `distance` sizes.
int self_hits(int count, double lo, double hi, float distance, std::uint32_t seed) {
  Memory nothing;
  nothing.dispatch.steering.normal_texel = nothing.dispatch.steering.color_texel = NONE;
  nothing.dispatch.steering.uv01_texel = nothing.dispatch.steering.uv23_texel = NONE;
  nothing.dispatch.steering.tangent_texel = NONE;
  const BoundMemory bound(nothing);
  RandomValues random(seed);
  int found = 0;
  for (int i = 0; i < count; ++i) {
    const float size = random.power_of_ten(lo, hi);
    const Spot spot = random_spot(random, size, size * distance);
    vec3 direction = unit_vector(random.direction());
    // Half of the rays leave at grazing angles.
    if (i % 2 == 0) {
      const vec3 normal = spot.surface.geometric_normal;
      direction =
          unit_vector(direction - normal * (dot_product(direction, normal) * (1.0f - random.power_of_ten(-7, 0))));
    }
    found += hits_itself(spot, direction) ? 1 : 0;
  }
  return found;
}

TEST(SpawnRay, no_triangle_of_any_size_is_hit_from_its_own_surface) {
  EXPECT_EQ(self_hits(1000000, -8, 8, 1.0f, 33), 0);
}
TEST(SpawnRay, nor_far_from_the_origin) {
  EXPECT_EQ(self_hits(300000, -3, 0, 1e3f, 34), 0);
  EXPECT_EQ(self_hits(300000, -5, 0, 1e5f, 35), 0);
}

TEST(SpawnRay, the_offset_is_small) {
  // Position error per axis 2^-24 (2 |v0| + 6 extent), along the normal at most sqrt(3) times that.
  Memory nothing;
  nothing.dispatch.steering.normal_texel = NONE;
  const BoundMemory bound(nothing);
  RandomValues random(36);
  for (int i = 0; i < 100000; ++i) {
    const Spot spot = random_spot(random, 1.0f, random.power_of_ten(-2, 3));
    const vec3 extent = max(abs(spot.v1 - spot.v0), abs(spot.v2 - spot.v0));
    const float largest = max3(abs(spot.v0)) + 3.0f * max3(extent);
    const vec3 direction = random.direction();
    ASSERT_LT(glm::distance(spawn_origin(spot.surface, direction), spot.surface.position), 0x1p-24f * 4.5f * largest);
  }
}

TEST(SpawnRay, it_leaves_on_the_side_of_the_direction) {
  SurfacePoint surface{};
  surface.position = vec3(1, 2, 3);
  surface.position_error = vec3(0.5f, 0.25f, 0.125f);
  surface.geometric_normal = vec3(0, 1, 0);
  EXPECT_EQ(spawn_origin(surface, vec3(1, 0.1f, 0)), vec3(1, 2.25f, 3));
  EXPECT_EQ(spawn_origin(surface, vec3(1, -0.1f, 0)), vec3(1, 1.75f, 3));
}

}  // namespace
}  // namespace vernier::shader
