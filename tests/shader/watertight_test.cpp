// Rays aimed at the edges and vertices of a closed mesh, through the shipped box and triangle tests.
#include <gtest/gtest.h>

#include "shader/bound_bvh.h"
#include "shader/bumpy_sphere.h"
#include "shader/random_values.h"
#include "shader/shader.h"

namespace vernier::shader {
namespace {

constexpr int kRays = 250000;  // each case; a million in all

/// How many of kRays from within a closed mesh, aimed at a point of an edge that `aim_at` picks, hit nothing.
template <typename AimAt>
int misses(float scale, const vec3& offset, std::uint32_t seed, const AimAt& aim_at) {
  const ClosedMesh mesh = bumpy_sphere(5);
  Memory scene = bvh_memory(corners_of(mesh, scale, offset));
  const BoundMemory bound(scene);
  RandomValues random(seed);
  int missed = 0;
  for (int i = 0; i < kRays; ++i) {
    const glm::uvec3& t = mesh.triangles[random.word() % mesh.triangles.size()];
    const vec3 aim = aim_at(random, mesh.positions[t.x] * scale + offset, mesh.positions[t.y] * scale + offset);
    // Star-shaped around the origin and nowhere nearer than 0.7.
    const vec3 origin = random.in_cube() * (0.3f * scale) + offset;
    const Found found = traverse_bvh(Search(Ray(origin, aim - origin), 0.0f, NONE, LARGEST_FLOAT, false));
    missed += found.hit.triangle == NONE ? 1 : 0;
  }
  return missed;
}

vec3 on_edge(RandomValues& random, const vec3& a, const vec3& b) {
  return a + (b - a) * random.in(0, 1);
}
vec3 on_vertex(RandomValues&, const vec3& a, const vec3&) {
  return a;
}

TEST(Watertight, no_ray_at_an_edge_gets_out) {
  EXPECT_EQ(misses(0.5f, vec3(0), 21, on_edge), 0);
}
TEST(Watertight, no_ray_at_a_vertex_gets_out) {
  EXPECT_EQ(misses(0.5f, vec3(0), 22, on_vertex), 0);
}
TEST(Watertight, no_ray_at_an_edge_of_a_small_mesh_far_out_gets_out) {
  EXPECT_EQ(misses(0x1p-10f, vec3(0.7f, -0.9f, 0.3f), 23, on_edge), 0);
}
TEST(Watertight, no_ray_at_a_vertex_of_a_tiny_mesh_gets_out) {
  EXPECT_EQ(misses(0x1p-30f, vec3(0), 24, on_vertex), 0);
}

}  // namespace
}  // namespace vernier::shader
