#include "scene/flat_normals.h"

#include <gtest/gtest.h>

namespace vernier {
namespace {

/// A square in two triangles with a normal at each corner; the last tells the second triangle from flat.
Scene square_with(const glm::vec3& normal, const glm::vec3& last) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  mesh.normals = {normal, normal, normal, last};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  mesh.triangle_materials = {0, 0};
  Scene scene;
  scene.meshes = {mesh};
  return scene;
}

bool drops(Scene scene) {
  drop_flat_normals(scene);
  EXPECT_EQ(scene.meshes[0].normals.empty(), scene.meshes[0].flat_normals);
  return scene.meshes[0].flat_normals;
}

TEST(DropFlatNormals, drops_what_says_nothing) {
  EXPECT_TRUE(drops(square_with({0, 0, 1}, {0, 0, 1})));
  EXPECT_TRUE(drops(square_with({0, 0, -1}, {0, 0, -1}))) << "shading takes the side of the triangle";
  EXPECT_TRUE(drops(square_with({0, 0, 1}, {0x1p-23f, 0, 1}))) << "an ulp is what interpolation rounds away";
}

TEST(DropFlatNormals, keeps_what_bends_one_corner) {
  EXPECT_FALSE(drops(square_with({0, 0, 1}, {0x1p-20f, 0, 1})));
  EXPECT_FALSE(drops(square_with({0, 0, 1}, {1, 0, 0})));
  EXPECT_FALSE(drops(square_with({0, 0, 1}, {0, 0, -1}))) << "corners of one triangle on two sides";
  EXPECT_FALSE(drops(square_with({0, 0, 1}, {0, 0, 0}))) << "a corner without a normal says something else";
}

TEST(DropFlatNormals, a_mesh_without_normals_is_left_alone) {
  Scene scene = square_with({0, 0, 1}, {0, 0, 1});
  scene.meshes[0].normals.clear();
  drop_flat_normals(scene);
  EXPECT_FALSE(scene.meshes[0].flat_normals);
}

}  // namespace
}  // namespace vernier
