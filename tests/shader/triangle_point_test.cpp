#include <gtest/gtest.h>

#include <bit>

#include "shader/shader.h"

namespace vernier::shader {
namespace {

/// A vertex of two texels whose first one has `material`.
void add_vertex(Memory& scene, std::uint32_t material) {
  scene.vertices.push_back({0, 0, 0, material});
  scene.vertices.push_back({0, 0, 0, 99});
}

TEST(TrianglePoint, offsets_lead_both_ways_from_vertex_0) {
  Memory scene;
  scene.dispatch.steering.vertex_texels = 2;
  for (std::uint32_t i = 0; i < 8; ++i) add_vertex(scene, 10 + i);
  const BoundMemory bound(scene);
  const std::uint32_t flags = BVH_TRIANGLE | BVH_TRIANGLE_NOT_OPAQUE;
  EXPECT_EQ(fetch_vertices(flags | BVH_VERTEX_BITS(5u), 2u | 0xfffdu << 16), uvec4(5, 7, 2, 15));
  EXPECT_EQ(fetch_vertices(flags | BVH_VERTEX_BITS(5u), 0xfffbu | 1u << 16), uvec4(5, 0, 6, 15));
  EXPECT_EQ(fetch_vertices(BVH_TRIANGLE, 1u | 2u << 16), uvec4(0, 1, 2, 10));
}

TEST(TrianglePoint, where_vertices_have_no_texels_the_record_has_the_material) {
  Memory scene;
  const BoundMemory bound(scene);
  EXPECT_EQ(fetch_vertices(BVH_TRIANGLE, 123456u).w, 123456u);
}

TEST(TrianglePoint, the_point_has_what_its_record_says) {
  Memory scene;
  scene.dispatch.steering.vertex_texels = 2;
  for (std::uint32_t i = 0; i < 4; ++i) add_vertex(scene, 20 + i);
  scene.records.resize(3, uvec4(0));
  const auto bits = [](float value) { return std::bit_cast<std::uint32_t>(value); };
  scene.records.push_back({0, 0, 0, BVH_TRIANGLE | BVH_VERTEX_BITS(3u)});
  scene.records.push_back({bits(1), 0, 0, 0xffffu | 0xfffeu << 16});
  scene.records.push_back({0, bits(1), 0, 7u});
  const BoundMemory bound(scene);
  const Ray ray(vec3(0.25f, 0.5f, 1), vec3(0, 0, -1));
  const TrianglePoint point = triangle_point(ray, Hit(1.0f, 7u, 1u, INSTANCE_WORLD));
  EXPECT_EQ(point.vertices, uvec4(3, 2, 1, 23));
  EXPECT_EQ(point.position, vec3(0.25f, 0.5f, 0));
}

}  // namespace
}  // namespace vernier::shader
