#include "render/bake_instances.h"

#include <gtest/gtest.h>

#include <bit>

#include "shared/render_constants.h"
#include "unit/reference/test_scenes.h"

namespace vernier {
namespace {

/// Every instance copied.
BakedScene copied(const Scene& scene, const TracedSpace& space, UvSets uvs = UvSets::all) {
  return bake_instances(scene, space, plan_instances(scene, Sharing::never), uvs);
}

glm::vec4 attribute(const BakedScene& baked, std::uint32_t vertex, std::uint32_t texel) {
  glm::vec4 value;
  for (std::uint32_t i = 0; i < 4; ++i) {
    value[static_cast<int>(i)] = std::bit_cast<float>(baked.vertices[4 * (vertex * baked.layout.texels + texel) + i]);
  }
  return value;
}

/// One triangle (0,0,0) (1,0,0) (0,1,0) with every attribute, placed by `world_from_object`.
Scene triangle_scene(const glm::dmat4& world_from_object) {
  Scene scene;
  test::add_black(scene);
  Mesh& mesh = test::add_polygon(scene, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  mesh.normals.assign(3, glm::vec3(0, 0.6f, 0.8f));
  mesh.tangents.assign(3, glm::vec4(1, 0, 0, 1));
  mesh.colors = {{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 0.5f}};
  mesh.uvs[0] = {{0, 0}, {1, 0}, {0, 1}};
  mesh.uvs[3] = {{5, 6}, {7, 8}, {9, 10}};
  scene.materials[0].textures[TEXTURE_SLOT_NORMAL].texture = 0;  // reads tangents and UV set 0
  scene.instances[0].world_from_object = world_from_object;
  return scene;
}

TEST(BakeInstances, attributes_lie_where_the_layout_says) {
  const BakedScene baked = copied(triangle_scene(glm::dmat4(1)), {});
  const VertexLayout& layout = baked.layout;
  EXPECT_EQ(layout.texels, 5u);
  ASSERT_EQ(baked.vertices.size(), 3u * 5 * 4);
  EXPECT_EQ(attribute(baked, 0, layout.normal), glm::vec4(0, 0.6f, 0.8f, 0));
  EXPECT_EQ(attribute(baked, 1, layout.uv01), glm::vec4(1, 0, 0, 0));
  EXPECT_EQ(attribute(baked, 2, layout.uv23), glm::vec4(0, 0, 9, 10));
  EXPECT_EQ(attribute(baked, 2, layout.color), glm::vec4(0, 0, 1, 0.5f));
  EXPECT_EQ(attribute(baked, 0, layout.tangent), glm::vec4(1, 0, 0, 1));
  EXPECT_EQ(baked.corners[0].v1, glm::vec3(1, 0, 0));
}

TEST(BakeInstances, what_no_mesh_has_takes_no_room) {
  Scene scene = triangle_scene(glm::dmat4(1));
  Mesh& mesh = scene.meshes[0];
  mesh.normals.clear();
  mesh.tangents.clear();
  mesh.uvs = {};
  const VertexLayout layout = copied(scene, {}).layout;
  EXPECT_EQ(layout.texels, 2u) << "the first has the material";
  EXPECT_EQ(layout.color, 1u);
  for (std::uint32_t texel : {layout.normal, layout.uv01, layout.uv23, layout.tangent}) EXPECT_EQ(texel, NONE);
  mesh.colors.clear();
  EXPECT_TRUE(copied(scene, {}).vertices.empty());
}

TEST(BakeInstances, what_nothing_reads_takes_no_room) {
  Scene scene = triangle_scene(glm::dmat4(1));
  EXPECT_EQ(copied(scene, {}, UvSets::of_textures).layout.uv23, NONE);
  TextureUse& use = scene.materials[0].textures[TEXTURE_SLOT_NORMAL];
  use.uv_set = 3;
  const VertexLayout of_set_3 = copied(scene, {}, UvSets::of_textures).layout;
  EXPECT_EQ(of_set_3.uv01, NONE);
  EXPECT_EQ(of_set_3.uv23, 1u);
  use.texture = -1;
  const VertexLayout untextured = copied(scene, {}, UvSets::of_textures).layout;
  EXPECT_EQ(untextured.texels, 2u) << "normal and colour";
  EXPECT_EQ(untextured.tangent, NONE);
  EXPECT_EQ(copied(scene, {}).layout.texels, 4u) << "but for tangents";
}

TEST(BakeInstances, normals_go_by_the_inverse_transpose) {
  glm::dmat4 flat(1);
  flat[1][1] = 0.5;  // halves y: normals lean towards y
  const BakedScene baked = copied(triangle_scene(flat), {});
  const glm::vec3 n(attribute(baked, 0, baked.layout.normal));
  EXPECT_LT(glm::distance(n, glm::normalize(glm::vec3(0, 1.2f, 0.8f))), 1e-7f);
  EXPECT_EQ(baked.corners[0].v2, glm::vec3(0, 0.5f, 0));
}

TEST(BakeInstances, a_mirror_keeps_the_front_in_front) {
  glm::dmat4 mirror(1);
  mirror[0][0] = -1;
  const BakedScene baked = copied(triangle_scene(mirror), {});
  const BvhTriangle& t = baked.corners[0];
  EXPECT_GT(glm::cross(t.v1 - t.v0, t.v2 - t.v0).z, 0.0f);
  EXPECT_EQ(baked.triangles[1], 2u);
  EXPECT_EQ(baked.triangles[2], 1u);
  EXPECT_EQ(attribute(baked, 0, baked.layout.tangent), glm::vec4(-1, 0, 0, -1));
  EXPECT_EQ(attribute(baked, 0, baked.layout.normal), glm::vec4(0, 0.6f, 0.8f, 0));
}

TEST(BakeInstances, triangles_are_numbered_over_instances) {
  Scene scene;
  test::add_black(scene);
  test::add_square(scene, 0.0f);
  test::add_black(scene);
  test::add_square(scene, 1.0f);
  scene.instances.push_back(scene.instances[0]);
  const BakedScene baked = copied(scene, {});
  ASSERT_EQ(baked.corners.size(), 6u);
  EXPECT_EQ(baked.first_triangles, (std::vector<std::uint32_t>{0, 2, 4}));
  for (std::uint32_t i = 0; i < 6; ++i) {
    EXPECT_EQ(baked.corners[i].id, i);
    // Both halves of a square meet their diagonal, the longest edge, opposite corner 1 or 3: traced from there on.
    EXPECT_EQ(baked.triangles[4 * i], 4 * (i / 2) + (i % 2 == 0 ? 1 : 3));
    EXPECT_EQ(baked.triangles[4 * i + 3], i / 2 == 1 ? 1u : 0u);
  }
}

TEST(BakeInstances, positions_are_worked_out_in_double_and_rounded_once) {
  glm::dmat4 far(1);
  far[3] = glm::dvec4(1e9, 0, 0, 1);
  TracedSpace space;
  space.center = glm::dvec3(1e9, 0, 0);
  space.metres_per_unit = 2.0;
  const BakedScene baked = copied(triangle_scene(far), space);
  EXPECT_EQ(baked.corners[0].v0, glm::vec3(0));
  EXPECT_EQ(baked.corners[0].v1, glm::vec3(0.5f, 0, 0));
}

TEST(BakeInstances, zero_has_one_sign) {
  glm::dmat4 turned(1);
  turned[0][0] = turned[1][1] = -1;
  const BakedScene baked = copied(triangle_scene(turned), {});
  for (const glm::vec3& v : {baked.corners[0].v0, baked.corners[0].v1, baked.corners[0].v2}) {
    for (int axis = 0; axis < 3; ++axis) EXPECT_NE(std::bit_cast<std::uint32_t>(v[axis]), 0x80000000u);
  }
}

}  // namespace
}  // namespace vernier
