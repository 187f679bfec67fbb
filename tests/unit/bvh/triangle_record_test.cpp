#include "bvh/triangle_record.h"

#include <gtest/gtest.h>

#include "bvh/decode_record.h"
#include "shared/bvh_record.h"

namespace vernier {
namespace {

BvhTriangle triangle_at(float z, std::uint32_t id) {
  return {glm::vec3(0, 0, z), glm::vec3(1, 0, z), glm::vec3(0, 2, z), id};
}

TEST(ListTriangles, keeps_order_ids_and_what_lets_light_pass) {
  const std::vector<BvhTriangle> triangles = {triangle_at(3, 0), triangle_at(-1, 1), triangle_at(2, 2)};
  const Bvh bvh = list_triangles(triangles, [](std::uint32_t id) { return id == 1; });
  ASSERT_EQ(bvh.records.size(), 3u);
  EXPECT_EQ(bvh.triangle_count, 3u);
  EXPECT_EQ(bvh.node_count, 0u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_TRUE(is_triangle(bvh.records[i]));
    EXPECT_EQ((bvh.records[i][3] & BVH_TRIANGLE_NOT_OPAQUE) != 0, i == 1);
    const BvhTriangle decoded = decode_triangle(bvh.records[i]);
    EXPECT_EQ(decoded.v0, triangles[i].v0);
    EXPECT_EQ(decoded.v1, triangles[i].v1);
    EXPECT_EQ(decoded.v2, triangles[i].v2);
    EXPECT_EQ(decoded.id, i);
  }
  EXPECT_EQ(bvh.bounds.lo, glm::vec3(0, 0, -1));
  EXPECT_EQ(bvh.bounds.hi, glm::vec3(1, 2, 3));
}

TEST(ListTriangles, leaves_out_what_has_no_area) {
  const std::vector<BvhTriangle> triangles = {
      triangle_at(0, 0), {glm::vec3(0), glm::vec3(1), glm::vec3(2), 1}, triangle_at(1, 2)};
  const Bvh bvh = list_triangles(triangles, {});
  ASSERT_EQ(bvh.records.size(), 2u);
  EXPECT_EQ(decode_triangle(bvh.records[1]).id, 2u);
  EXPECT_TRUE(list_triangles({}, {}).records.empty());
}

}  // namespace
}  // namespace vernier
