#include "scene/frame_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace vernier {
namespace {

// Largest |nx| and |ny| of the box in the camera's picture, and the same with signs.
struct Seen {
  glm::dvec2 lo{1e9};
  glm::dvec2 hi{-1e9};
};

Seen project(const Camera& camera, const WorldBounds& box, double aspect) {
  Seen seen;
  const glm::dmat4 camera_from_world = glm::inverse(camera.world_from_camera);
  for (int i = 0; i < 8; ++i) {
    const glm::dvec4 corner(i & 1 ? box.hi.x : box.lo.x, i & 2 ? box.hi.y : box.lo.y, i & 4 ? box.hi.z : box.lo.z, 1.0);
    const glm::dvec4 p = camera_from_world * corner;
    EXPECT_LT(p.z, 0.0);
    const double t = std::tan(0.5 * camera.vertical_fov);
    const glm::dvec2 n(p.x / (-p.z * t * aspect), p.y / (-p.z * t));
    seen.lo = glm::min(seen.lo, n);
    seen.hi = glm::max(seen.hi, n);
  }
  return seen;
}

Seen joined(const Seen& a, const Seen& b) {
  return {glm::min(a.lo, b.lo), glm::max(a.hi, b.hi)};
}

TEST(FrameCamera, BoxTouchesTheMarginAndIsCentred) {
  for (const double aspect : {0.5, 1.0, 16.0 / 9.0}) {
    for (const WorldBounds& box :
         {WorldBounds{{-1, -1, -1}, {1, 1, 1}}, WorldBounds{{100, 0, 0}, {101, 9, 2}},
          WorldBounds{{0, 0, 0}, {50, 1, 3}}, WorldBounds{{-2, 0, -2}, {2, 0, 2}}, WorldBounds{{0, 0, 0}, {0, 3, 0}}}) {
      const Seen seen = project(frame_camera(box, 0.7, aspect), box, aspect);
      const double widest = std::max({seen.hi.x, seen.hi.y, -seen.lo.x, -seen.lo.y});
      EXPECT_NEAR(widest, 1.0 / 1.05, 1e-9);
      EXPECT_NEAR(seen.lo.x + seen.hi.x, 0.0, 1e-9);
      EXPECT_NEAR(seen.lo.y + seen.hi.y, 0.0, 1e-9);
    }
  }
}

TEST(FrameScene, VerticesTouchTheMarginWhereTheirBoxIsMuchLarger) {
  // A diagonal strip: its box reaches far beyond it in every view.
  Scene scene;
  Mesh mesh;
  for (int i = 0; i < 20; ++i) mesh.positions.emplace_back(i, i % 2, -i);
  for (unsigned i = 0; i + 2 < 20; ++i) mesh.triangles.emplace_back(i, i + 1, i + 2);
  scene.meshes.push_back(mesh);
  scene.instances.resize(1);
  for (const double aspect : {0.5, 16.0 / 9.0}) {
    const Camera camera = frame_scene(scene, 0.7, aspect);
    Seen seen;
    for (const glm::vec3& place : mesh.positions) {
      seen = joined(seen, project(camera, {glm::dvec3(place), glm::dvec3(place)}, aspect));
    }
    EXPECT_NEAR(std::max({seen.hi.x, seen.hi.y, -seen.lo.x, -seen.lo.y}), 1.0 / 1.05, 1e-9);
    EXPECT_NEAR(seen.lo.x + seen.hi.x, 0.0, 1e-9);
    EXPECT_NEAR(seen.lo.y + seen.hi.y, 0.0, 1e-9);
  }
}

TEST(FrameCamera, LooksFromThreeQuartersAndIsRigid) {
  const Camera camera = frame_camera({{-1, -1, -1}, {1, 1, 1}}, 0.7, 1.5);
  const glm::dvec3 back(camera.world_from_camera[2]);
  EXPECT_GT(std::min({back.x, back.y, back.z}), 0.1);
  const glm::dmat3 axes(camera.world_from_camera);
  const glm::dmat3 identity = glm::transpose(axes) * axes;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) EXPECT_NEAR(identity[i][j], i == j ? 1.0 : 0.0, 1e-15);
  }
}

TEST(FrameCamera, FlatBoxesAreSeenFromTheirSide) {
  for (int axis = 0; axis < 3; ++axis) {
    WorldBounds box{glm::dvec3(-1.0), glm::dvec3(1.0)};
    box.lo[axis] = box.hi[axis] = 0.0;
    const glm::dvec3 back(frame_camera(box, 0.7, 1.5).world_from_camera[2]);
    EXPECT_GT(back[axis], 0.8);
    EXPECT_LT(back[axis], 0.98);
  }
}

TEST(FrameCamera, NoExtentIsOneMetre) {
  const WorldBounds point{{5, 5, 5}, {5, 5, 5}};
  const Camera camera = frame_camera(point, 0.7, 1.0);
  const Camera cube = frame_camera({glm::dvec3(4.5), glm::dvec3(5.5)}, 0.7, 1.0);
  EXPECT_EQ(camera.world_from_camera, cube.world_from_camera);
  EXPECT_TRUE(std::isfinite(frame_camera(world_bounds(Scene{}), 0.7, 1.0).world_from_camera[3].x));
}

Scene two_placed_triangles() {
  Scene scene;
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {9, 9, 9}};
  mesh.triangles = {{0, 1, 2}, {0, 0, 0}};
  scene.meshes.push_back(mesh);
  scene.instances.resize(2);
  scene.instances[1].world_from_object = glm::dmat4(2, 0, 0, 0, 0, -2, 0, 0, 0, 0, 2, 0, 1e6, 0, 3, 1);
  return scene;
}

TEST(WorldBounds, InstancesAndUsedVerticesOnly) {
  const WorldBounds bounds = world_bounds(two_placed_triangles());
  EXPECT_EQ(bounds.lo, glm::dvec3(0, -2, 0));
  EXPECT_EQ(bounds.hi, glm::dvec3(1e6 + 2, 1, 3));
}

TEST(WorldBounds, TrianglesThatAreLinesCountAsTracedAndNotAsSeen) {
  Scene scene = two_placed_triangles();
  Mesh& mesh = scene.meshes[0];
  const auto last = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), {{1e3f, 0, 0}, {2e3f, 0, 0}, {3e3f, 0, 0}});
  mesh.triangles.push_back({last, last, last});
  mesh.triangles.push_back({last, last + 1, last + 2});
  EXPECT_EQ(seen_bounds(scene).hi, glm::dvec3(1e6 + 2, 1, 3));
  EXPECT_EQ(world_bounds(scene).hi, glm::dvec3(1e6 + 6e3, 1, 3));
  mesh.triangles.back() = {last, last + 1, last + 1};
  EXPECT_EQ(world_bounds(scene).hi, glm::dvec3(1e6 + 2, 1, 3));
}

// Radiance of a white diffuse surface with normal n, lit by all lights of the scene and the gradient.
glm::vec3 white_surface(const Scene& scene, const glm::dvec3& n, std::size_t first_light) {
  glm::vec3 sum = glm::mix(scene.environment.ground, scene.environment.sky, float(0.5 + n.y / 3.0));
  for (std::size_t i = first_light; i < scene.lights.size(); ++i) {
    const double cosine = std::max(0.0, -glm::dot(scene.lights[i].direction, n));
    sum += scene.lights[i].intensity * float(cosine / 3.14159265358979);
  }
  return sum;
}

TEST(DefaultLighting, WhiteIsBrightInTheKeyAndNotBlackInItsShadow) {
  Scene scene;
  const Camera camera = frame_camera({glm::dvec3(-1.0), glm::dvec3(1.0)}, 0.7, 1.5);
  add_default_lighting(scene, camera);
  ASSERT_EQ(scene.lights.size(), 2u);
  const glm::dvec3 to_key = -scene.lights[0].direction;
  EXPECT_NEAR(glm::length(to_key), 1.0, 1e-12);
  EXPECT_LT(glm::dot(to_key, glm::dvec3(camera.world_from_camera[0])), 0.0);  // left of the camera
  EXPECT_GT(glm::dot(to_key, glm::dvec3(camera.world_from_camera[1])), 0.0);  // above it
  const glm::vec3 lit = white_surface(scene, to_key, 0);
  const glm::vec3 shadow = white_surface(scene, to_key, 1);
  EXPECT_NEAR((lit.r + lit.g + lit.b) / 3.0f, 0.85f, 0.05f);
  EXPECT_NEAR((shadow.r + shadow.g + shadow.b) / 3.0f, 0.27f, 0.05f);
}

TEST(DefaultLighting, LightsOfTheFileAndAChosenEnvironmentStay) {
  Scene lit;
  lit.lights.emplace_back();
  add_default_lighting(lit, Camera{});
  EXPECT_EQ(lit.lights.size(), 1u);
  Scene chosen;
  chosen.environment.ground = glm::vec3(0.5f);
  add_default_lighting(chosen, Camera{});
  EXPECT_EQ(chosen.lights.size(), 2u);
  EXPECT_EQ(chosen.environment.sky, glm::vec3(0.0f));
  chosen.lights.resize(1);
  add_default_lighting(chosen, Camera{});
  EXPECT_EQ(chosen.environment.sky, glm::vec3(0.0f));
  EXPECT_EQ(chosen.environment.ground, glm::vec3(0.5f));
}

TEST(DefaultLighting, AroundLightsTheEnvironmentIsDim) {
  Scene unlit, lit;
  add_default_lighting(unlit, Camera{});
  lit.lights.emplace_back();
  add_default_lighting(lit, Camera{});
  for (const int channel : {0, 1, 2}) {
    EXPECT_GT(lit.environment.sky[channel], lit.environment.ground[channel]);
    EXPECT_GT(lit.environment.ground[channel], 0.02f);
    EXPECT_LT(lit.environment.sky[channel], 0.5f * unlit.environment.sky[channel]);
  }
}

}  // namespace
}  // namespace vernier
