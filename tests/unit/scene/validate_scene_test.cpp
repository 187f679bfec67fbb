#include "scene/validate_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "error.h"

namespace vernier {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

Scene one_triangle() {
  Scene scene;
  scene.source = "test";
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  mesh.triangle_materials = {0};
  scene.meshes.push_back(mesh);
  scene.materials.emplace_back();
  scene.instances.emplace_back();
  return scene;
}

std::string refusal(Scene scene) {
  try {
    validate_scene(scene);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::refused);
    return error.what();
  }
  return "not refused";
}

TEST(ValidateScene, GoodSceneStaysAsItIs) {
  Scene scene = one_triangle();
  validate_scene(scene);
  EXPECT_TRUE(scene.warnings.empty());
  EXPECT_EQ(scene.meshes[0].triangles[0], glm::uvec3(0, 1, 2));
}

TEST(ValidateScene, DropsTrianglesAndKeepsTheirNumbers) {
  Scene scene = one_triangle();
  Mesh& mesh = scene.meshes[0];
  mesh.positions.insert(mesh.positions.end(), {{kNan, 0, 0}, {0, INFINITY, 0}});
  mesh.triangles = {{0, 1, 3}, {0, 1, 9}, {0, 1, 2}, {4, 1, 2}};
  mesh.triangle_materials = {0, 0, 0, 0};
  validate_scene(scene);
  EXPECT_EQ(mesh.triangles, (std::vector<glm::uvec3>{glm::uvec3(0), glm::uvec3(0), {0, 1, 2}, glm::uvec3(0)}));
  for (const glm::vec3& p : mesh.positions) EXPECT_TRUE(std::isfinite(p.x + p.y + p.z));
  EXPECT_EQ(scene.warnings, (std::vector<std::string>{
                                "test: mesh 0, triangle 0 and 1 more: triangles with a non-finite corner are dropped",
                                "test: mesh 0, triangle 1: triangles with an index out of range are dropped"}));
}

TEST(ValidateScene, NegativeZeroBecomesZero) {
  Scene scene = one_triangle();
  scene.meshes[0].positions[0] = glm::vec3(-0.0f);
  validate_scene(scene);
  EXPECT_FALSE(std::signbit(scene.meshes[0].positions[0].x));
}

TEST(ValidateScene, NonFiniteVertexValuesBecomeNone) {
  Scene scene = one_triangle();
  Mesh& mesh = scene.meshes[0];
  mesh.normals.assign(3, glm::vec3(kNan, 0, 1));
  mesh.tangents.assign(3, glm::vec4(0, 0, 0, kNan));
  mesh.colors.assign(3, glm::vec4(INFINITY));
  mesh.uvs[1].assign(3, glm::vec2(0, kNan));
  validate_scene(scene);
  EXPECT_EQ(mesh.normals[2], glm::vec3(0.0f));
  EXPECT_EQ(mesh.tangents[2], glm::vec4(0.0f));
  EXPECT_EQ(mesh.colors[2], glm::vec4(1.0f));
  EXPECT_EQ(mesh.uvs[1][2], glm::vec2(0.0f));
  EXPECT_EQ(scene.warnings.size(), 4u);
}

TEST(ValidateScene, DropsSingularTransforms) {
  for (const glm::dmat4& transform : {glm::dmat4(0.0), glm::dmat4(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1e-30, 0, 0, 0, 0, 1),
                                      glm::dmat4(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, std::nan(""), 0, 0, 0, 0, 1),
                                      glm::dmat4(1, 0, 0, 0.5, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1),
                                      glm::dmat4(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1e39, 0, 0, 1)}) {
    Scene scene = one_triangle();
    scene.instances.emplace_back().world_from_object = transform;
    validate_scene(scene);
    EXPECT_EQ(scene.instances.size(), 1u);
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_NE(scene.warnings[0].find("instance 1"), std::string::npos);
  }
}

TEST(ValidateScene, KeepsUnevenMirroredAndTinyTransforms) {
  for (const glm::dvec3& scale : {glm::dvec3(1e4, 1e-4, 1e-4), glm::dvec3(-1, 1, 1), glm::dvec3(1e-12)}) {
    Scene scene = one_triangle();
    for (int axis = 0; axis < 3; ++axis) scene.instances[0].world_from_object[axis][axis] = scale[axis];
    validate_scene(scene);
    EXPECT_EQ(scene.instances.size(), 1u);
  }
}

TEST(ValidateScene, NothingLeftIsRefused) {
  const std::string nothing = "test: nothing to render, no triangle is left";
  Scene empty;
  empty.source = "test";
  EXPECT_EQ(refusal(empty), nothing);
  Scene dropped = one_triangle();
  dropped.meshes[0].positions[1].x = kNan;
  EXPECT_EQ(refusal(dropped), nothing + "; mesh 0, triangle 0: triangles with a non-finite corner are dropped");
  Scene flat = one_triangle();
  flat.meshes[0].positions[2] = flat.meshes[0].positions[1];
  EXPECT_EQ(refusal(flat), nothing);
  Scene unused = one_triangle();
  unused.instances.clear();
  EXPECT_EQ(refusal(unused), nothing);
  Scene without_vertices = one_triangle();
  without_vertices.meshes[0].positions.clear();
  EXPECT_EQ(refusal(without_vertices),
            nothing + "; mesh 0, triangle 0: triangles with an index out of range are dropped");
}

TEST(ValidateScene, WrongReferencesAreRefused) {
  Scene scene = one_triangle();
  scene.instances[0].mesh = 1;
  EXPECT_EQ(refusal(scene), "test: instance 0: mesh 1 is beyond the 1 of the scene");
  scene = one_triangle();
  scene.meshes[0].triangle_materials[0] = 7;
  EXPECT_EQ(refusal(scene), "test: mesh 0: material 7 is beyond the 1 of the scene");
  scene = one_triangle();
  scene.meshes[0].triangle_materials.clear();
  EXPECT_EQ(refusal(scene), "test: mesh 0: 0 materials of triangles do not fit 1");
  scene = one_triangle();
  scene.meshes[0].normals.resize(2);
  EXPECT_EQ(refusal(scene), "test: mesh 0: 2 normals do not fit 3");
  scene = one_triangle();
  scene.materials[0].textures[TEXTURE_SLOT_NORMAL].texture = 0;
  EXPECT_EQ(refusal(scene), "test: material 0: texture 0 is beyond the 0 of the scene");
  scene = one_triangle();
  scene.environment.texture = 2;
  EXPECT_EQ(refusal(scene), "test: environment: texture 2 is beyond the 0 of the scene");
  scene = one_triangle();
  scene.textures.push_back({"", {}, std::make_shared<Texels>(Texels{TEXTURE_FORMAT_FLOAT, 1, 1, {0u}})});
  EXPECT_EQ(refusal(scene), "test: texture 0: the texels do not fit width, height and format");
}

TEST(ValidateScene, SenselessLightsCamerasAndMaterialsAreToldAndRepaired) {
  Scene scene = one_triangle();
  scene.lights.resize(3);
  scene.lights[0].intensity.r = kNan;
  scene.lights[1].kind = LightKind::directional;
  scene.lights[1].direction = glm::dvec3(0.0);
  scene.lights[2].range = -1.0;
  scene.cameras.resize(2);
  scene.cameras[0].vertical_fov = 4.0;
  scene.materials[0].ior = kNan;
  validate_scene(scene);
  ASSERT_EQ(scene.lights.size(), 1u);
  EXPECT_EQ(scene.lights[0].range, std::numeric_limits<double>::infinity());
  EXPECT_EQ(scene.cameras.size(), 1u);
  EXPECT_EQ(scene.materials[0].ior, 1.5f);
  EXPECT_EQ(scene.warnings.size(), 4u);
}

TEST(ValidateScene, HugeTextureCoordinatesAreToldAndKept) {
  Scene scene = one_triangle();
  scene.meshes[0].uvs[0] = {{0, 65536}, {-65537, 0}, {0, 1e30f}};
  validate_scene(scene);
  EXPECT_EQ(scene.meshes[0].uvs[0][2].y, 1e30f);
  EXPECT_EQ(scene.warnings, (std::vector<std::string>{"test: mesh 0, vertex 1 and 1 more: texture coordinates beyond "
                                                      "65536 are too coarse to place a texture"}));
}

}  // namespace
}  // namespace vernier
