#include "effects/used_materials.h"

#include <gtest/gtest.h>

#include "one_triangle.h"

namespace vernier {
namespace {

TEST(UsedMaterials, OnlyThoseOfTrianglesThatAreSeen) {
  Scene scene = one_triangle();
  scene.materials.resize(4);
  Mesh& mesh = scene.meshes[0];
  mesh.triangles.push_back({0, 0, 1});
  mesh.triangle_materials.push_back(1);
  Mesh without_instance = mesh;
  without_instance.triangle_materials = {2, 2};
  scene.meshes.push_back(without_instance);
  const std::vector<MaterialUsage> usage = used_materials(scene);
  ASSERT_EQ(usage.size(), 4u);
  EXPECT_TRUE(usage[0].used);
  EXPECT_FALSE(usage[1].used) << "two equal corners";
  EXPECT_FALSE(usage[2].used) << "a mesh without an instance";
  EXPECT_FALSE(usage[3].used) << "no triangle at all";
}

TEST(UsedMaterials, ThinTrianglesCount) {
  Scene scene = one_triangle();
  scene.meshes[0].positions = {{0, 0, 0}, {1, 1, 1}, {3, 3, 3}};
  EXPECT_TRUE(used_materials(scene)[0].used) << "rounding may open them once they are transformed";
}

TEST(UsedMaterials, UnusedMaterialAsksForNothing) {
  Scene scene = one_triangle();
  scene.materials.resize(2);
  scene.materials[1].emission = glm::vec3(1.0f);
  scene.materials[1].roughness = 0.0f;
  EXPECT_EQ(bits_of(scene), 0u);
}

}  // namespace
}  // namespace vernier
