#include "gltf_file.h"

namespace vernier {
namespace {

/// Five vertices drawn with `indices` in `mode`.
Mesh draw(int mode, const std::vector<std::uint16_t>& indices) {
  GltfFile file;
  const int position = file.vec3({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 2, 2, 0});
  const int index = file.accessor(indices, "SCALAR", kUnsignedShort, 1);
  file.add("meshes",
           {{"primitives", {{{"attributes", {{"POSITION", position}}}, {"indices", index}, {"mode", mode}}}}});
  file.add("nodes", {{"mesh", 0}});
  return file.load().meshes[0];
}

TEST(GltfMeshes, make_triangles_of_lists_strips_and_fans) {
  using Triangles = std::vector<glm::uvec3>;
  EXPECT_EQ(draw(4, {0, 1, 2, 4, 3, 2}).triangles, (Triangles{{0, 1, 2}, {4, 3, 2}}));
  EXPECT_EQ(draw(5, {0, 1, 2, 3, 4}).triangles, (Triangles{{0, 1, 2}, {1, 3, 2}, {2, 3, 4}}));
  EXPECT_EQ(draw(6, {0, 1, 2, 3, 4}).triangles, (Triangles{{1, 2, 0}, {2, 3, 0}, {3, 4, 0}}));
}

TEST(GltfMeshes, read_byte_and_word_indices) {
  GltfFile file;
  add_triangle(file);
  auto& primitive = file.json["meshes"][0]["primitives"][0];
  primitive["indices"] = file.accessor(std::vector<std::uint8_t>{2, 1, 0}, "SCALAR", kUnsignedByte, 1);
  EXPECT_EQ(file.load().meshes[0].triangles[0], glm::uvec3(2, 1, 0));
  primitive["indices"] = file.accessor(std::vector<std::uint32_t>{1, 0, 2}, "SCALAR", kUnsignedInt, 1);
  EXPECT_EQ(file.load().meshes[0].triangles[0], glm::uvec3(1, 0, 2));
  primitive["indices"] = file.accessor(std::vector<std::uint32_t>{0, 1, 3}, "SCALAR", kUnsignedInt, 1);
  expect_refused(file, "mesh 0, primitive 0: index 3 is beyond 3 vertices");
  primitive["indices"] = file.accessor(std::vector<float>{0, 1, 2}, "SCALAR", kFloat, 1);
  expect_refused(file, "indices must be unsigned integer scalars");
}

TEST(GltfMeshes, warn_of_points_and_lines_once_with_their_count) {
  GltfFile file;
  add_triangle(file);
  auto& primitives = file.json["meshes"][0]["primitives"];
  for (const int mode : {0, 1, 2, 3}) primitives.push_back({{"attributes", {{"POSITION", 0}}}, {"mode", mode}});
  const Scene scene = file.load();
  EXPECT_EQ(scene.meshes[0].triangles.size(), 1u);
  EXPECT_EQ(scene.warnings,
            (std::vector<std::string>{"mesh 0, primitive 1: points and lines are not drawn (4 primitives)"}));
  expect_refused([&] { file.load(true); }, "points and lines");
}

TEST(GltfMeshes, append_primitives_with_their_materials_and_a_default_one_at_the_end) {
  GltfFile file;
  add_triangle(file);
  file.add("materials", {{"name", "red"}});
  file.add("materials", {{"name", "blue"}});
  auto& primitives = file.json["meshes"][0]["primitives"];
  const int other = file.vec3({5, 0, 0, 6, 0, 0, 5, 1, 0});
  const int color = file.accessor(std::vector<float>{1, 0, 0, 0, 1, 0, 0, 0, 1}, "VEC3", kFloat, 3);
  primitives.push_back({{"attributes", {{"POSITION", other}, {"COLOR_0", color}}}, {"material", 1}});
  primitives.push_back({{"attributes", {{"POSITION", 0}}}, {"material", 0}});
  const Scene scene = file.load();
  const Mesh& mesh = scene.meshes[0];
  EXPECT_EQ(mesh.positions.size(), 6u) << "primitives 0 and 2 share their vertices";
  EXPECT_EQ(mesh.triangles, (std::vector<glm::uvec3>{{0, 1, 2}, {3, 4, 5}, {0, 1, 2}}));
  EXPECT_EQ(mesh.triangle_materials, (std::vector<std::uint32_t>{2, 1, 0}));
  EXPECT_EQ(mesh.colors[0], glm::vec4(1));
  EXPECT_EQ(mesh.colors[4], glm::vec4(0, 1, 0, 1));
  ASSERT_EQ(scene.materials.size(), 3u);
  EXPECT_EQ(scene.materials[2].base_color, glm::vec4(1));
  EXPECT_EQ(scene.materials[2].metallic, 1.0f);
  EXPECT_EQ(scene.materials[2].roughness, 1.0f);
}

TEST(GltfMeshes, read_four_uv_sets_and_warn_of_more) {
  GltfFile file;
  add_triangle(file);
  auto& attributes = file.json["meshes"][0]["primitives"][0]["attributes"];
  for (int set = 0; set < 5; ++set) {
    const auto u = float(set);
    attributes["TEXCOORD_" + std::to_string(set)] =
        file.accessor(std::vector<float>{u, 0, u, 1, u, 2}, "VEC2", kFloat, 2);
  }
  const Scene scene = file.load();
  EXPECT_EQ(scene.meshes[0].uvs[3][2], glm::vec2(3, 2));
  EXPECT_TRUE(has_warning(scene, "mesh 0, primitive 0: attribute TEXCOORD_4 is ignored"));
}

TEST(GltfMeshes, make_normals_and_tangents_unit_and_leave_none_for_those_without_length) {
  GltfFile file;
  add_triangle(file);
  auto& attributes = file.json["meshes"][0]["primitives"][0]["attributes"];
  attributes["NORMAL"] = file.vec3({0, 0, 2, 0, 0, 0, 0, 3, 4});
  attributes["TANGENT"] = file.accessor(std::vector<float>{2, 0, 0, -1, 0, 0, 0, 1, 0, 1, 0, 1}, "VEC4", kFloat, 4);
  const Mesh mesh = file.load().meshes[0];
  EXPECT_EQ(mesh.normals, (std::vector<glm::vec3>{{0, 0, 1}, {0, 0, 0}, {0, 0.6f, 0.8f}}));
  EXPECT_EQ(mesh.tangents, (std::vector<glm::vec4>{{1, 0, 0, -1}, {0, 0, 0, 0}, {0, 1, 0, 1}}));
  attributes["NORMAL"] = file.vec3({0, 0, 1, 0, 0, 1});
  expect_refused(file, "NORMAL: 2 elements do not go with 3 vertices");
}

TEST(GltfMeshes, ignore_tangents_without_normals) {
  GltfFile file;
  add_triangle(file);
  file.json["meshes"][0]["primitives"][0]["attributes"]["TANGENT"] =
      file.accessor(std::vector<float>{1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1}, "VEC4", kFloat, 4);
  EXPECT_TRUE(file.load().meshes[0].tangents.empty());
}

TEST(GltfMeshes, leave_normals_out_where_the_file_has_none) {
  GltfFile file;
  add_triangle(file);
  const Mesh mesh = file.load().meshes[0];
  EXPECT_TRUE(mesh.normals.empty() && mesh.tangents.empty() && mesh.colors.empty() && mesh.uvs[0].empty());
}

}  // namespace
}  // namespace vernier
