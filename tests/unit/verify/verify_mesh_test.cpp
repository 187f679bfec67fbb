#include "verify/verify_mesh.h"

#include <gtest/gtest.h>

#include <map>

namespace vernier {
namespace {

/// Whether every edge is run through once each way: closed and wound the same way all over.
bool is_closed(const VerifyMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const glm::uvec3& t : mesh.triangles) {
    for (int corner = 0; corner < 3; ++corner) ++edges[{t[corner], t[(corner + 1) % 3]}];
  }
  for (const auto& [edge, count] : edges) {
    if (count != 1 || edges.count({edge.second, edge.first}) == 0) return false;
  }
  return true;
}

SampleRandom numbers() {
  return SampleRandom(1, "mesh", 0);
}

TEST(VerifyMesh, spheres_and_cones_are_closed) {
  SampleRandom random = numbers();
  EXPECT_TRUE(is_closed(sphere_mesh(16, 16, 1.0, 6.0, random)));
  EXPECT_TRUE(is_closed(sphere_mesh(4, 256, 1.0, 1.0, random)));
  EXPECT_TRUE(is_closed(double_cone(3, 1.0, random)));
  EXPECT_TRUE(is_closed(double_cone(1024, 0.0, random)));
  EXPECT_FALSE(is_closed(grid_mesh(2, 0, 0.0f)));
}

TEST(VerifyMesh, a_cone_has_its_valence) {
  SampleRandom random = numbers();
  const VerifyMesh mesh = double_cone(7, 1.0, random);
  int at_top = 0;
  for (const glm::uvec3& t : mesh.triangles) at_top += t.x == 0 ? 1 : 0;
  EXPECT_EQ(at_top, 7);
}

TEST(VerifyMesh, unit_scale_brings_the_largest_coordinate_just_below_1) {
  VerifyMesh mesh{{{3.0f, -5.0f, 0.0f}}, {}};
  EXPECT_EQ(unit_scale(mesh), 0.125);
  mesh.positions.front() = glm::vec3(0.0f, 0.0f, 0x1p-40f);
  EXPECT_EQ(unit_scale(mesh), 0x1p39);
}

TEST(VerifyMesh, placing_rounds_once) {
  const VerifyMesh mesh{{{1.0f, 0.0f, 0.0f}}, {}};
  const glm::vec3 p = placed(mesh, 0x1p-30, {1.0, 2.0, 3.0}).positions.front();
  EXPECT_EQ(p, glm::vec3(1.0f, 2.0f, 3.0f));
}

TEST(VerifyMesh, soup_stays_within_its_cube) {
  SampleRandom random = numbers();
  for (const glm::vec3& p : triangle_soup(100, 0.3, random).positions) {
    for (int i = 0; i < 3; ++i) ASSERT_LE(std::abs(p[i]), 1.0f);
  }
}

}  // namespace
}  // namespace vernier
