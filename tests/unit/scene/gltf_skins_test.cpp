#include <cmath>

#include "gltf_file.h"

namespace vernier {
namespace {

TEST(GltfMorphTargets, are_added_with_the_weights_of_the_mesh_or_of_the_node) {
  GltfFile file;
  add_triangle(file);
  const int move = file.vec3({0, 0, 4, 0, 0, 4, 0, 0, 4});
  const int turn = file.vec3({0, 1, -1, 0, 0, 0, 0, 0, 0});
  auto& mesh = file.json["meshes"][0];
  mesh["primitives"][0]["attributes"]["NORMAL"] = file.vec3({0, 0, 1, 0, 0, 1, 0, 0, 1});
  mesh["primitives"][0]["targets"] = {{{"POSITION", move}}, {{"POSITION", move}, {"NORMAL", turn}}};
  EXPECT_EQ(file.load().meshes[0].positions[1], glm::vec3(1, 0, 0)) << "weights default to 0";
  mesh["weights"] = {0.25, 0};
  file.add("nodes", {{"mesh", 0}, {"weights", {0, 1}}});
  const Scene scene = file.load();
  ASSERT_EQ(scene.meshes.size(), 2u) << "another pose is another mesh";
  EXPECT_EQ(scene.meshes[0].positions[1], glm::vec3(1, 0, 1));
  EXPECT_EQ(scene.meshes[0].normals[0], glm::vec3(0, 0, 1));
  EXPECT_EQ(scene.meshes[1].positions[1], glm::vec3(1, 0, 4));
  EXPECT_EQ(scene.meshes[1].normals[0], glm::vec3(0, 1, 0));
  EXPECT_EQ(scene.instances[1].mesh, 1u);
  mesh["primitives"][0]["targets"][0]["POSITION"] = file.vec3({0, 0, 4});
  expect_refused(file, "target 0 POSITION: 1 elements do not go with 3 vertices");
}

/// Joint 1 stands at (0, 10, 0), turned a quarter about z; joint 2 at the origin of the world. Node 0 is far away.
GltfFile& add_skin(GltfFile& file) {
  add_triangle(file);
  const double half = std::sqrt(0.5);
  file.json["nodes"][0]["skin"] = 0;
  file.json["nodes"][0]["translation"] = {500, 0, 0};
  file.add("nodes", {{"translation", {0, 10, 0}}, {"rotation", {0, 0, half, half}}});
  file.add("nodes", {{"name", "still"}});
  file.json["skins"] = {{{"joints", {1, 2}}}};
  auto& attributes = file.json["meshes"][0]["primitives"][0]["attributes"];
  attributes["NORMAL"] = file.vec3({1, 0, 0, 1, 0, 0, 1, 0, 0});
  attributes["JOINTS_0"] =
      file.accessor(std::vector<std::uint8_t>{0, 9, 9, 9, 1, 0, 0, 0, 0, 1, 0, 0}, "VEC4", kUnsignedByte, 4);
  attributes["WEIGHTS_0"] =
      file.accessor(std::vector<float>{1, 0, 0, 0, 1, 0, 0, 0, 0.5f, 0.5f, 0, 0}, "VEC4", kFloat, 4);
  return file;
}

void expect_near(const glm::vec3& actual, const glm::vec3& expected) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(actual[c], expected[c], 1e-5f);
}

TEST(GltfSkins, place_vertices_by_their_joints_and_ignore_the_node_of_the_mesh) {
  GltfFile file;
  const Scene scene = add_skin(file).load();
  EXPECT_EQ(scene.instances[0].world_from_object, glm::dmat4(1.0));
  expect_near(scene.meshes[0].positions[0], {0, 10, 0});
  expect_near(scene.meshes[0].positions[1], {1, 0, 0});
  expect_near(scene.meshes[0].positions[2], {-0.5f, 5.5f, 0});  // mean of (-1, 10, 0) and (0, 1, 0)
  expect_near(scene.meshes[0].normals[0], {0, 1, 0});
  expect_near(scene.meshes[0].normals[1], {1, 0, 0});
}

TEST(GltfSkins, apply_inverse_bind_matrices) {
  GltfFile file;
  add_skin(file);
  const std::vector<float> matrices = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -10, 0, 1,
                                       1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0,   0, 1};
  file.json["skins"][0]["inverseBindMatrices"] = file.accessor(matrices, "MAT4", kFloat, 16);
  expect_near(file.load().meshes[0].positions[0], {10, 10, 0});
  file.json["accessors"].back()["count"] = 1;
  expect_refused(file, "skin 0: 1 inverse bind matrices are fewer than 2 joints");
}

TEST(GltfSkins, refuse_joints_that_do_not_exist_where_they_weigh) {
  GltfFile file;
  add_skin(file);
  file.json["skins"][0]["joints"] = {1};
  expect_refused(file, "mesh 0, primitive 0: joint 1 is beyond 1 joints");
}

}  // namespace
}  // namespace vernier
