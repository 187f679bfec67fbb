#include <gtest/gtest.h>

#include "shader/corner_attributes.h"
#include "shader/random_values.h"

namespace vernier::shader {
namespace {

vec3 interpolated_at(const Corners& corners, float b1, float b2) {
  Memory scene = memory_with(corners);
  const BoundMemory bound(scene);
  return smooth_point(unit_triangle_point(b1, b2), kUp, true).normal;
}

TEST(VertexNormals, vertex_normals_are_weighed_and_made_unit) {
  Corners corners;
  corners.normals[1] = vec3(1, 0, 0);
  expect_unit_near(interpolated_at(corners, 0.5f, 0), vec3(kHalfRoot, 0, kHalfRoot));
  expect_unit_near(interpolated_at(corners, 0.25f, 0.25f), vec3(1, 0, 3) / std::sqrt(10.0f));
  EXPECT_EQ(interpolated_at(corners, 0, 0), kUp);
  EXPECT_EQ(interpolated_at(corners, 1, 0), vec3(1, 0, 0));
}

TEST(VertexNormals, vertex_normals_that_lean_outwards_raise_the_surface) {
  Corners corners;
  corners.normals = {vec3(-kHalfRoot, 0, kHalfRoot), vec3(kHalfRoot, 0, kHalfRoot), vec3(0, kHalfRoot, kHalfRoot)};
  Memory scene = memory_with(corners);
  const BoundMemory bound(scene);
  const auto rise_seen_along = [](const vec3& direction) {
    return surface_point(unit_triangle_point(0.25f, 0.25f), DeviceMaterial{}, no_slot_texels(), direction).rise;
  };
  // Halves of b (p - P).n: 0.5 x 0.25, 0.25 x 0.75 and 0.25 x 0.75, each along (lean, 1).
  const vec3 expected = 0.5f * vec3(0.1875f - 0.125f, 0.1875f, 0.5f);
  EXPECT_LT(glm::distance(rise_seen_along(vec3(0, 0, -1)), expected), 4 * 0x1p-24f);
  EXPECT_EQ(rise_seen_along(vec3(0, 0, 1)), vec3(0)) << "from behind it is hollow";
  for (vec3& normal : corners.normals) normal = -normal;
  Memory turned = memory_with(corners);
  const BoundMemory bound_turned(turned);
  EXPECT_LT(glm::distance(rise_seen_along(vec3(0, 0, -1)), expected), 4 * 0x1p-24f) << "normals against the winding";
}

TEST(VertexNormals, flat_vertex_normals_raise_nothing) {
  Memory scene = memory_with({});
  const BoundMemory bound(scene);
  for (const float b1 : {0.0f, 0.25f, 0.7f})
    EXPECT_EQ(smooth_point(unit_triangle_point(b1, 0.3f), kUp, true).rise, vec3(0));
}

TEST(VertexNormals, vertex_normals_take_the_geometric_side) {
  RandomValues random(5);
  for (int i = 0; i < 1000; ++i) {
    Corners corners;
    for (vec3& normal : corners.normals) normal = random.direction();
    const vec3 one = interpolated_at(corners, 0.25f, 0.5f);
    for (vec3& normal : corners.normals) normal = -normal;
    const vec3 other = interpolated_at(corners, 0.25f, 0.5f);
    ASSERT_GE(one.z, 0.0f);
    ASSERT_EQ(one, other);  // negation is exact
  }
}

TEST(VertexNormals, without_a_usable_vertex_normal_the_geometric_one_stands) {
  Corners flat_corner;
  flat_corner.normals = {vec3(1, 0, 0), vec3(0), vec3(1, 0, 0)};
  EXPECT_EQ(interpolated_at(flat_corner, 0.25f, 0.25f), kUp);
  Corners opposite;
  opposite.normals = {vec3(0), vec3(1, 0, 0), vec3(-1, 0, 0)};
  opposite.normals[0] = vec3(0, 1, 0);
  EXPECT_EQ(interpolated_at(opposite, 0.5f, 0.5f), kUp) << "a sum of zero";
  Corners tilted;
  tilted.normals.fill(vec3(1, 0, 0));
  Memory scene = memory_with(tilted);
  const BoundMemory bound(scene);
  scene.dispatch.steering.normal_texel = NONE;
  EXPECT_EQ(smooth_point(unit_triangle_point(0.25f, 0.25f), kUp, true).normal, kUp);
  scene.dispatch.steering.normal_texel = 0;
  EXPECT_EQ(smooth_point(unit_triangle_point(0.25f, 0.25f), kUp, true).normal, vec3(1, 0, 0));
  EFFECTS = ~EFFECT_SMOOTH_NORMALS;
  EXPECT_EQ(smooth_point(unit_triangle_point(0.25f, 0.25f), kUp, true).normal, kUp);
  EFFECTS = 0xffffffffu;
}

}  // namespace
}  // namespace vernier::shader
