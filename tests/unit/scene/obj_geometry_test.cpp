#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "error.h"
#include "scene/load_scene.h"
#include "temporary_folder.h"

namespace vernier {
namespace {

Scene load(const std::string& text, const LoadOptions& options = {}) {
  const TemporaryFolder folder;
  return load_scene(folder.write("model.obj", text), options);
}

std::string refusal(const std::string& text, const LoadOptions& options = {}) {
  const TemporaryFolder folder;
  const std::string path = folder.write("model.obj", text);
  try {
    load_scene(path, options);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::refused);
    return std::string(error.what()).substr(path.size() + 2);
  }
  return "not refused";
}

const std::string kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

TEST(LoadObjGeometry, TriangleWithUvAndNormal) {
  const Scene scene = load(kTriangle + "vt 0.25 0.75\nvn 0 0 2\nf 1/1/1 2/1/1 3/1/1\n");
  ASSERT_EQ(scene.meshes.size(), 1u);
  const Mesh& mesh = scene.meshes[0];
  ASSERT_EQ(mesh.triangles.size(), 1u);
  EXPECT_EQ(mesh.positions[mesh.triangles[0][1]], glm::vec3(1, 0, 0));
  EXPECT_EQ(mesh.normals[0], glm::vec3(0, 0, 1));
  EXPECT_EQ(mesh.uvs[0][0], glm::vec2(0.25f, 0.25f));  // v downwards
  EXPECT_TRUE(mesh.colors.empty());
  EXPECT_EQ(scene.instances[0].world_from_object, glm::dmat4(1.0));
  EXPECT_TRUE(scene.warnings.empty());
}

TEST(LoadObjGeometry, NegativeIndicesCountBackFromTheFace) {
  const Scene scene = load(kTriangle + "f -3 -2 -1\nv 5 5 5\n");
  EXPECT_EQ(scene.meshes[0].positions[scene.meshes[0].triangles[0][0]], glm::vec3(0, 0, 0));
}

TEST(LoadObjGeometry, BadIndicesAreRefusedWithTheirLine) {
  EXPECT_EQ(refusal(kTriangle + "f 1 2 12\n"), "line 4: vertex 12 is beyond the 3 of the file");
  EXPECT_EQ(refusal(kTriangle + "\nf 0 1 2\n"), "line 5: index 0 does not exist, indices count from 1 or back from -1");
  EXPECT_EQ(refusal(kTriangle + "vt 0 0\nf 1/1 2/-0 3/1\n"),
            "line 5: index 0 does not exist, indices count from 1 or back from -1");
  EXPECT_EQ(refusal(kTriangle + "f 1 2 -4\n"), "line 4: a vertex index counts back before the first vertex");
  EXPECT_EQ(refusal(kTriangle + "vt 0 0\nf 1/-2 2/1 3/1\n"), "line 5: '1/-2' counts back before the first of the file");
  EXPECT_EQ(refusal(kTriangle + "vn 0 0 1\nf 1//-2 2//1 3//1\n"),
            "line 5: '1//-2' counts back before the first of the file");
  EXPECT_EQ(refusal(kTriangle + "f 1/1 2/1 3/1\n"), "line 4: texture vertex 1 is beyond the 0 of the file");
  EXPECT_EQ(refusal(kTriangle + "f 1//2 2//1 3//1\n"), "line 4: normal 2 is beyond the 0 of the file");
  EXPECT_EQ(refusal(kTriangle + "f 1 2 x\n"), "line 4: 'x' is not a corner of a face");
  EXPECT_EQ(refusal(kTriangle + "f 1 2 99999999999\n"), "line 4: '99999999999' is not a corner of a face");
  EXPECT_EQ(refusal("v 0 0\n"), "line 1: 'v 0 0' has fewer than 3 numbers");
  EXPECT_EQ(refusal("v 0 zero 0\n"), "line 1: 'zero' is not a number");
  for (const std::string word : {"1..2", "1-2", "1e", "1e+", ".", "-", "+.e1", "1e1.5", "--1"}) {
    EXPECT_EQ(refusal("v 0 " + word + " 0\n"), "line 1: '" + word + "' is not a number");
  }
}

TEST(LoadObjGeometry, FilesWithoutFacesAreRefused) {
  EXPECT_EQ(refusal(""), "no faces");
  EXPECT_EQ(refusal(kTriangle + "l 1 2\n"), "no faces");
  EXPECT_EQ(refusal(std::string(100, '\0')), "not a text file: byte 0 is 0");
  EXPECT_THROW(open_obj("/nonexistent/model.obj", {}), Error);
  EXPECT_THROW(open_obj("/", {}), Error);
}

TEST(LoadObjGeometry, NonFiniteVerticesDropTheirTrianglesOnly) {
  const Scene scene = load(kTriangle + "v nan 0 0\nv 0 -INF 0\nv 0 -1.#R 0\nf 1 2 3\nf 1 2 4\nf 1 2 5\nf 1 2 6\n");
  ASSERT_EQ(scene.meshes[0].triangles.size(), 4u);
  EXPECT_NE(scene.meshes[0].triangles[0], glm::uvec3(0));
  for (std::size_t i = 1; i < 4; ++i) EXPECT_EQ(scene.meshes[0].triangles[i], glm::uvec3(0));
  ASSERT_EQ(scene.warnings.size(), 1u);
  EXPECT_NE(scene.warnings[0].find("mesh 0, triangle 1 and 2 more"), std::string::npos);
}

TEST(LoadObjGeometry, CommentsMayTouchANumber) {
  const Scene scene = load("v 0 0 0#one\nv 1 0 0# two 3 4\nv 0 1 0.#\nf 1 2 3\n");
  ASSERT_EQ(scene.meshes[0].triangles.size(), 1u);
  EXPECT_NE(scene.meshes[0].triangles[0], glm::uvec3(0));
  EXPECT_TRUE(scene.warnings.empty());
}

TEST(LoadObjGeometry, PolygonsOfMoreThan255Corners) {
  std::string text;
  std::string face = "f";
  const int count = 300;
  for (int i = 0; i < count; ++i) {
    const double angle = 6.283185307179586 * i / count;
    text += "v " + std::to_string(std::cos(angle)) + " " + std::to_string(std::sin(angle)) + " 0\n";
    face += " " + std::to_string(i + 1);
  }
  const Scene scene = load(text + face + "\nf 1 2 3\n");
  EXPECT_EQ(scene.meshes[0].triangles.size(), 299u);
}

TEST(LoadObjGeometry, LinesMayBeJoinedAndEndInAnyWay) {
  const Scene scene = load("\xEF\xBB\xBFv 0 0 0\r\nv 1 0 0\rv 0 1 0 # corner\nf 1 \\\r\n 2 \\\n 3");
  EXPECT_EQ(scene.meshes[0].triangles.size(), 1u);
}

TEST(LoadObjGeometry, ObjectsAndGroupsBecomeInstancesWithTheirNames) {
  const Scene scene = load(kTriangle + "o first thing\nf 1 2 3\ng left arm\nf 1 2 3\nf 3 2 1\ng\nf 1 2 3\n");
  ASSERT_EQ(scene.instances.size(), 3u);
  EXPECT_EQ(scene.instances[0].name, "first thing");
  EXPECT_EQ(scene.instances[1].name, "left arm");
  EXPECT_EQ(scene.instances[2].name, "");
  EXPECT_EQ(scene.meshes[scene.instances[1].mesh].triangles.size(), 2u);
}

TEST(LoadObjGeometry, SurveyCoordinatesGoToTheTransform) {
  // The two objects share an edge: it must be the same floats in both.
  const Scene scene = load(
      "v 500000.125 5400000.25 300.5\nv 500010.0625 5400000.25 300.5\nv 500000.125 5400010.03 300.5\nv 500010 5400010 "
      "300.5\n"
      "o a\nf 1 2 3\no b\nf 3 2 4\n");
  EXPECT_EQ(scene.instances[0].world_from_object, scene.instances[1].world_from_object);
  const glm::dvec3 origin(scene.instances[0].world_from_object[3]);
  const glm::vec3 first = scene.meshes[0].positions[scene.meshes[0].triangles[0][0]];
  EXPECT_EQ(origin + glm::dvec3(first), glm::dvec3(500000.125, 5400000.25, 300.5));
  EXPECT_EQ(scene.meshes[0].positions[scene.meshes[0].triangles[0][2]],
            scene.meshes[1].positions[scene.meshes[1].triangles[0][0]]);
  EXPECT_LT(glm::length(first), 32.0f);
}

TEST(LoadObjGeometry, VerticesWithoutFacesMoveNoOrigin) {
  const std::string far_triangle =
      "v 4000000 5000000 100000\nv 4000001 5000000 100000\nv 4000000 5000001.25 100000\nf 1 2 3\n";
  const Scene scene = load(far_triangle + "v 0 0 0\np 4\n");
  EXPECT_EQ(scene.instances[0].world_from_object, load(far_triangle).instances[0].world_from_object);
  EXPECT_EQ(scene.meshes[0].positions, load(far_triangle).meshes[0].positions);
}

TEST(LoadObjGeometry, VertexColoursAreSrgb) {
  const Scene scene = load("v 0 0 0 1 0 0.5\nv 1 0 0 1 1 1\nv 0 1 0 0 0 0\nf 1 2 3\n");
  const glm::vec4 color = scene.meshes[0].colors[scene.meshes[0].triangles[0][0]];
  EXPECT_EQ(color.r, 1.0f);
  EXPECT_EQ(color.g, 0.0f);
  EXPECT_NEAR(color.b, 0.2140411f, 1e-6f);  // ((0.5 + 0.055) / 1.055)^2.4
  EXPECT_EQ(color.a, 1.0f);
}

// Two squares at a right angle, sharing the edge 2-3.
const std::string kBend = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 1 0 -1\nv 1 1 -1\n";

TEST(LoadObjGeometry, SmoothingGroupsShareNormalsWeighedByAngle) {
  const Scene scene = load(kBend + "s 7\nf 1 2 3 4\nf 2 5 6 3\n");
  const Mesh& mesh = scene.meshes[0];
  ASSERT_EQ(mesh.positions.size(), 6u);
  for (std::size_t i = 0; i < 6; ++i) {
    const bool shared = mesh.positions[i].x == 1.0f && mesh.positions[i].z == 0.0f;
    if (!shared) continue;
    // However the squares are cut, each has a right angle there: the mean of +Z and +X.
    EXPECT_NEAR(mesh.normals[i].x, std::sqrt(0.5), 1e-6);
    EXPECT_NEAR(mesh.normals[i].z, std::sqrt(0.5), 1e-6);
  }
}

TEST(LoadObjGeometry, OtherGroupsAndNoGroupStayFlat) {
  const Scene groups = load(kBend + "s 1\nf 1 2 3 4\ns 2\nf 2 5 6 3\n");
  ASSERT_EQ(groups.meshes[0].positions.size(), 8u);
  for (const glm::vec3& normal : groups.meshes[0].normals) EXPECT_NEAR(std::max(normal.x, normal.z), 1.0f, 1e-6f);
  for (const char* off : {"", "s off\n", "s 0\n"})
    EXPECT_TRUE(load(kBend + off + "f 1 2 3 4\nf 2 5 6 3\n").meshes[0].normals.empty());
}

TEST(LoadObjGeometry, NormalsOfTheFileBeatSmoothing) {
  const Scene scene = load(kTriangle + "vn 1 0 0\ns 1\nf 1//1 2//1 3//1\n");
  EXPECT_EQ(scene.meshes[0].normals[0], glm::vec3(1, 0, 0));
}

TEST(LoadObjGeometry, WhatIsNotReadIsToldOnceOrRefusedStrictly) {
  const std::string text = kTriangle + "l 1 2\np 1\ncstype bezier\ncurv 0 1 1 2\ncurv 0 1 1 2\nf 1 2 3\n";
  const Scene scene = load(text);
  ASSERT_EQ(scene.warnings.size(), 2u);
  EXPECT_NE(scene.warnings[0].find("line 4: lines and points are not drawn (2)"), std::string::npos);
  EXPECT_NE(scene.warnings[1].find("line 6: statements that are not supported: 'cstype', 'curv'"), std::string::npos);
  LoadOptions strict;
  strict.strict = true;
  EXPECT_EQ(refusal(text, strict), "line 4: lines and points are not drawn (2)");
}

TEST(LoadObjGeometry, ManyLinesAndMaterialChangesStayLinear) {
  std::string text = kTriangle;
  for (int i = 0; i < 20000; ++i) text += "usemtl m" + std::to_string(i) + "\nl 1 2 3\nf 1 2 3\n";
  EXPECT_EQ(load(text).meshes[0].triangles.size(), 20000u);
}

}  // namespace
}  // namespace vernier
