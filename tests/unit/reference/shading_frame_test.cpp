#include "reference/shading_frame.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "test_scenes.h"

namespace vernier::reference {
namespace {

void expect_near(const glm::dvec3& a, const glm::dvec3& b) {
  EXPECT_LT(glm::distance(a, b), 1e-6) << a.x << ' ' << a.y << ' ' << a.z;
}

ShadingFrame frame_at(const Scene& scene, glm::dvec3 origin, glm::dvec3 direction) {
  const TracedScene traced = prepare_scene(scene);
  const auto hit = closest_hit(traced, {origin, direction}, kNoTriangle);
  EXPECT_TRUE(hit);
  return shading_frame(traced, hit.value_or(Hit{0, 0.0, {1, 0, 0}, 1.0}), direction);
}

// A square whose vertex normals lean outwards in x by 45 degrees at x = -1 and x = 1.
Scene bent_square() {
  Scene scene;
  test::add_black(scene);
  const float h = std::sqrt(0.5f);
  test::add_square(scene, 0.0f).normals = {{-h, 0, h}, {h, 0, h}, {h, 0, h}, {-h, 0, h}};
  return scene;
}

TEST(ShadingFrame, FlatWithoutVertexNormals) {
  Scene scene;
  test::add_black(scene);
  test::add_square(scene, 0.0f);
  const ShadingFrame frame = frame_at(scene, {0.5, 0.25, 2}, {0, 0, -1});
  expect_near(frame.shading_normal, {0, 0, 1});
  expect_near(frame.position, {0.5, 0.25, 0});
  EXPECT_TRUE(frame.front);
}

TEST(ShadingFrame, SmoothNormalsAreInterpolated) {
  const double h = std::sqrt(0.5);
  const ShadingFrame frame = frame_at(bent_square(), {0.5, 0.25, 2}, {0, 0, -1});
  expect_near(frame.shading_normal, glm::normalize(glm::dvec3(0.5 * h, 0, h)));
  expect_near(frame.geometric_normal, {0, 0, 1});
}

TEST(ShadingFrame, NormalsThatLeanOutwardsRaiseTheSurface) {
  expect_near(frame_at(bent_square(), {0.5, 0.25, 2}, {0, 0, -1}).rise, {0, 0, 0.375});
  expect_near(frame_at(bent_square(), {0.5, 0.25, -2}, {0, 0, 1}).rise, {0, 0, 0});
}

TEST(ShadingFrame, OneZeroNormalMakesTheTriangleFlat) {
  Scene scene = bent_square();
  scene.meshes[0].normals[1] = glm::vec3(0.0f);  // only in triangle 0, below the diagonal
  expect_near(frame_at(scene, {0.5, 0.25, 2}, {0, 0, -1}).shading_normal, {0, 0, 1});
  EXPECT_GT(frame_at(scene, {0.25, 0.5, 2}, {0, 0, -1}).shading_normal.x, 0.1);
}

TEST(ShadingFrame, NormalsAgainstTheWindingAreTurned) {
  Scene scene = bent_square();
  for (glm::vec3& normal : scene.meshes[0].normals) normal = -normal;
  const double h = std::sqrt(0.5);
  expect_near(frame_at(scene, {0.5, 0.25, 2}, {0, 0, -1}).shading_normal, glm::normalize(glm::dvec3(0.5 * h, 0, h)));
}

TEST(ShadingFrame, TheBackTurnsBothNormals) {
  const ShadingFrame front = frame_at(bent_square(), {0.5, 0.25, 2}, {0, 0, -1});
  const ShadingFrame back = frame_at(bent_square(), {0.5, 0.25, -2}, {0, 0, 1});
  EXPECT_FALSE(back.front);
  expect_near(back.geometric_normal, {0, 0, -1});
  expect_near(back.shading_normal, -front.shading_normal);
}

TEST(ShadingFrame, NormalsFollowTheInverseTranspose) {
  Scene scene = bent_square();
  for (glm::vec3& normal : scene.meshes[0].normals) normal = {0.6f, 0, 0.8f};
  scene.instances[0].world_from_object = glm::scale(glm::dmat4(1.0), glm::dvec3(2, 1, 1));
  expect_near(frame_at(scene, {0.5, 0.25, 2}, {0, 0, -1}).shading_normal, glm::normalize(glm::dvec3(0.3, 0, 0.8)));
}

// A normal texture of one texel with the tangent space vector (0.6, 0, 0.8) or (0, 0.6, 0.8), in floats.
Scene textured_square(glm::vec3 m) {
  Scene scene;
  test::add_black(scene);
  test::add_square(scene, 0.0f);
  scene.meshes[0].uvs[0] = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};  // an upright image: v downwards
  Texels texels{TEXTURE_FORMAT_FLOAT, 1, 1, {}};
  for (int axis = 0; axis < 3; ++axis) texels.words.push_back(std::bit_cast<std::uint32_t>(0.5f * m[axis] + 0.5f));
  texels.words.push_back(0);
  scene.materials[0].textures[TEXTURE_SLOT_NORMAL].texture = test::add_texture(scene, std::make_shared<Texels>(texels));
  return scene;
}

TEST(ShadingFrame, NormalTextureFromUvs) {
  expect_near(frame_at(textured_square({0.6f, 0, 0.8f}), {0.5, 0.25, 2}, {0, 0, -1}).shading_normal, {0.6, 0, 0.8});
  // Green is up in the picture, glTF 2.0 section 3.9.3.
  expect_near(frame_at(textured_square({0, 0.6f, 0.8f}), {0.5, 0.25, 2}, {0, 0, -1}).shading_normal, {0, 0.6, 0.8});
}

TEST(ShadingFrame, NormalTextureOfAMirroredUvMap) {
  Scene scene = textured_square({0.6f, 0, 0.8f});
  for (glm::vec2& uv : scene.meshes[0].uvs[0]) uv.x = 1.0f - uv.x;
  expect_near(frame_at(scene, {0.5, 0.25, 2}, {0, 0, -1}).shading_normal, {-0.6, 0, 0.8});
}

TEST(ShadingFrame, NormalTextureThatIsLookedUpTurned) {
  Scene scene = textured_square({0.6f, 0, 0.8f});
  glm::mat3x2& uv = scene.materials[0].textures[TEXTURE_SLOT_NORMAL].uv_from_vertex_uv;
  uv = glm::mat3x2(-1, 0, 0, 1, 1, 0);  // mirrored
  expect_near(frame_at(scene, {0.5, 0.25, 2}, {0, 0, -1}).shading_normal, {-0.6, 0, 0.8});
  uv = glm::mat3x2(0, 1, -1, 0, 1, 0);  // the image's u runs against the vertices' v, which runs down
  expect_near(frame_at(scene, {0.5, 0.25, 2}, {0, 0, -1}).shading_normal, {0, 0.6, 0.8});
}

TEST(ShadingFrame, NormalScaleBendsMore) {
  Scene scene = textured_square({0.6f, 0, 0.8f});
  scene.materials[0].normal_scale = 2.0f;
  expect_near(frame_at(scene, {0.5, 0.25, 2}, {0, 0, -1}).shading_normal, glm::normalize(glm::dvec3(1.2, 0, 0.8)));
}

TEST(ShadingFrame, VertexTangentsComeBeforeUvs) {
  Scene scene = textured_square({0.6f, 0, 0.8f});
  scene.meshes[0].tangents.assign(4, glm::vec4(0, 1, 0, 1));
  expect_near(frame_at(scene, {0.5, 0.25, 2}, {0, 0, -1}).shading_normal, {0, 0.6, 0.8});
  scene.meshes[0].tangents[0] = glm::vec4(0);  // one is missing: back to the uvs
  expect_near(frame_at(scene, {0.5, 0.25, 2}, {0, 0, -1}).shading_normal, {0.6, 0, 0.8});
}

// Mirroring the object mirrors the picture: the bump that pointed to +Y still does, with tangents and without.
TEST(ShadingFrame, MirroredInstancesKeepTheirBumps) {
  for (const bool tangents : {true, false}) {
    Scene scene = textured_square({0, 0.6f, 0.8f});
    if (tangents) scene.meshes[0].tangents.assign(4, glm::vec4(1, 0, 0, 1));
    expect_near(frame_at(scene, {0.5, 0.25, 2}, {0, 0, -1}).shading_normal, {0, 0.6, 0.8});
    scene.instances[0].world_from_object = glm::scale(glm::dmat4(1.0), glm::dvec3(-1, 1, 1));
    expect_near(frame_at(scene, {0.5, 0.25, 2}, {0, 0, -1}).shading_normal, {0, 0.6, 0.8});
  }
}

TEST(ShadingFrame, WithoutUvsTheNormalTextureIsIgnored) {
  Scene scene = textured_square({0.6f, 0, 0.8f});
  scene.meshes[0].uvs[0].clear();
  expect_near(frame_at(scene, {0.5, 0.25, 2}, {0, 0, -1}).shading_normal, {0, 0, 1});
}

}  // namespace
}  // namespace vernier::reference
