#include "scene/view_side.h"

#include <gtest/gtest.h>

#include <utility>

namespace vernier {
namespace {

const glm::dvec3 kUsual = glm::normalize(glm::dvec3(0.9, 0.6, 1.0));
const glm::dvec3 kClosed(0.0);

// Quads of a cube of side 2 around the origin, each facing outwards, but for the one whose middle is `open`.
Scene cube(const glm::dvec3& open) {
  Scene scene;
  Mesh mesh;
  for (const int axis : {0, 1, 2}) {
    for (const double sign : {-1.0, 1.0}) {
      glm::dvec3 normal(0.0), along(0.0);
      normal[axis] = sign;
      along[(axis + 1) % 3] = 1.0;
      if (normal == open) continue;
      const glm::dvec3 across = glm::cross(normal, along);
      const auto first = static_cast<std::uint32_t>(mesh.positions.size());
      for (const auto& [s, t] : {std::pair{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}}) {
        mesh.positions.emplace_back(normal + s * along + t * across);
      }
      mesh.triangles.emplace_back(first, first + 1, first + 2);
      mesh.triangles.emplace_back(first, first + 2, first + 3);
    }
  }
  scene.meshes.push_back(mesh);
  scene.instances.resize(1);
  return scene;
}

Scene room(const glm::dvec3& open) {
  Scene scene = cube(open);
  for (glm::uvec3& triangle : scene.meshes[0].triangles) std::swap(triangle.y, triangle.z);
  return scene;
}

double backs(const Scene& scene) {
  return look_from(scene, world_bounds(scene), kUsual).backs;
}

glm::dvec3 chosen(const Scene& scene) {
  return choose_view_side(scene, world_bounds(scene), kUsual);
}

TEST(ViewSide, AClosedShapeShowsNoBacks) {
  EXPECT_EQ(backs(cube(kClosed)), 0.0);
  EXPECT_EQ(chosen(cube(kClosed)), kUsual);
}

TEST(ViewSide, CoverIsTheShareOfTheDiagonalsSquare) {
  const SideView front = look_from(cube(kClosed), world_bounds(cube(kClosed)), glm::dvec3(0, 0, 1));
  EXPECT_NEAR(front.covered, 4.0 / 12.0, 0.03);
}

TEST(ViewSide, AClosedRoomShowsNothingElse) {
  EXPECT_EQ(backs(room(kClosed)), 1.0);
  EXPECT_EQ(chosen(room(kClosed)), kUsual) << "no side is better";
}

TEST(ViewSide, ARoomIsSeenThroughItsOpening) {
  for (const glm::dvec3 open : {glm::dvec3(0, 0, 1), glm::dvec3(1, 0, 0), glm::dvec3(-1, 0, 0), glm::dvec3(0, 0, -1)}) {
    EXPECT_EQ(chosen(room(open)), open);
    EXPECT_EQ(glm::dvec3(frame_scene(room(open), 0.7, 1.5).world_from_camera[2]), open);
  }
}

TEST(ViewSide, ASheetIsNotSeenAlongItself) {
  Scene sheet = room(kClosed);
  // The wall at +Z, which faces the inside, alone but for a small step in depth: not a flat box.
  sheet.meshes[0].triangles = {sheet.meshes[0].triangles[10], sheet.meshes[0].triangles[11]};
  sheet.meshes[0].positions[20].z -= 0.1f;
  EXPECT_EQ(backs(sheet), 1.0);
  EXPECT_EQ(chosen(sheet), glm::dvec3(0, 0, -1));
}

TEST(ViewSide, AMirroredInstanceIsWoundTheOtherWay) {
  Scene scene = cube(kClosed);
  scene.instances[0].world_from_object[0] *= -1.0;
  EXPECT_EQ(backs(scene), 0.0);
}

TEST(ViewSide, TheNearestTriangleCounts) {
  Scene scene = room(kClosed);
  scene.instances.resize(2);
  scene.meshes.push_back(cube(kClosed).meshes[0]);
  scene.instances[1].mesh = 1;
  scene.instances[1].world_from_object = glm::dmat4(glm::dmat3(0.5));
  EXPECT_EQ(backs(scene), 1.0) << "the small cube is inside";
  scene.instances[1].world_from_object = glm::dmat4(glm::dmat3(2.0));
  EXPECT_EQ(backs(scene), 0.0) << "the large cube is around";
}

TEST(ViewSide, NothingToSee) {
  EXPECT_EQ(backs(Scene{}), 0.0);
  EXPECT_EQ(chosen(Scene{}), kUsual);
}

}  // namespace
}  // namespace vernier
