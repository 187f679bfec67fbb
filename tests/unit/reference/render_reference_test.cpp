#include "reference/render_reference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "error.h"
#include "reference/camera_rays.h"
#include "test_scenes.h"

namespace vernier {
namespace {

const Layer& layer(const ImageFile& file, std::string_view name) {
  for (const Layer& candidate : file.layers)
    if (candidate.name == name) return candidate;
  throw std::out_of_range(std::string(name));
}

const std::vector<float>& floats(const ImageFile& file, std::string_view name) {
  return std::get<std::vector<float>>(layer(file, name).values);
}

const std::vector<std::uint32_t>& ids(const ImageFile& file, std::string_view name) {
  return std::get<std::vector<std::uint32_t>>(layer(file, name).values);
}

// A white diffuse floor y = 0 under a point light, seen from the front and above.
Scene floor_scene() {
  Scene scene;
  test::add_black(scene).base_color = {1.0f, 0.5f, 0.25f, 1.0f};
  test::add_polygon(scene, {{-50, 0, 50}, {50, 0, 50}, {50, 0, -50}, {-50, 0, -50}});
  scene.lights.push_back(Light{});
  scene.lights[0].position = {1, 3, -4};
  scene.lights[0].intensity = glm::vec3(20.0f);
  return scene;
}

Camera high_camera() {
  Camera camera;
  camera.world_from_camera = glm::dmat4(glm::dvec4(1, 0, 0, 0), glm::dvec4(0, 0.8, -0.6, 0), glm::dvec4(0, 0.6, 0.8, 0),
                                        glm::dvec4(0, 4, 2, 1));
  return camera;
}

ReferenceSettings small(std::uint32_t spp) {
  ReferenceSettings settings;
  settings.width = 24;
  settings.height = 16;
  settings.spp = spp;
  return settings;
}

TEST(RenderReference, FloorUnderAPointLightMatchesTheClosedForm) {
  const Scene scene = floor_scene();
  const Camera camera = high_camera();
  const ImageFile file = render_reference(scene, camera, small(1), {});
  const std::vector<float>& colors = floats(file, "");
  int lit = 0;
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 24; ++x) {
      const reference::Ray ray = reference::camera_ray(camera, 24, 16, {x + 0.5, y + 0.5});
      const double t = -ray.origin.y / ray.direction.y;
      const glm::dvec3 to_light = scene.lights[0].position - (ray.origin + t * ray.direction);
      const double distance = glm::length(to_light);
      const double red = 20.0 * to_light.y / (std::numbers::pi * distance * distance * distance);
      const std::size_t pixel = 4 * (y * 24 + x);
      if (ray.direction.y >= 0.0 || std::abs(ray.origin.x + t * ray.direction.x) > 50.0 || t > 45.0) continue;
      ++lit;
      EXPECT_FLOAT_EQ(colors[pixel], static_cast<float>(red));
      EXPECT_FLOAT_EQ(colors[pixel + 2], static_cast<float>(red / 4.0));
      EXPECT_EQ(colors[pixel + 3], 1.0f);
    }
  }
  EXPECT_GT(lit, 200);
}

TEST(RenderReference, LayersOfAHitAndOfAMiss) {
  Scene scene = floor_scene();
  test::add_black(scene).base_color = {0.0f, 1.0f, 0.0f, 1.0f};
  test::add_square(scene, -6.0f, 0.5f);
  Camera camera;
  camera.orthographic = true;
  camera.half_height = 1.0;
  camera.world_from_camera[3] = glm::dvec4(0, 0, 4, 1);
  ReferenceSettings settings = small(1);
  settings.width = settings.height = 8;
  scene.instances.erase(scene.instances.begin());  // the floor, seen edge-on
  const ImageFile file = render_reference(scene, camera, settings, {});
  EXPECT_EQ(file.full_width, 8);
  EXPECT_EQ(file.layers.size(), 10u);
  const std::size_t hit = 4 * 8 + 3;  // the centre of pixel (3, 4) is (-0.125, -0.125)
  EXPECT_FLOAT_EQ(floats(file, "depth")[hit], 10.0f);
  EXPECT_FLOAT_EQ(floats(file, "position")[3 * hit], -0.125f);
  EXPECT_FLOAT_EQ(floats(file, "position")[3 * hit + 2], -6.0f);
  EXPECT_FLOAT_EQ(floats(file, "normal")[3 * hit + 2], 1.0f);
  EXPECT_FLOAT_EQ(floats(file, "shading_normal")[3 * hit + 2], 1.0f);
  EXPECT_FLOAT_EQ(floats(file, "uv")[2 * hit + 1], 0.375f);
  EXPECT_FLOAT_EQ(floats(file, "albedo")[3 * hit + 1], 1.0f);
  EXPECT_EQ(ids(file, "object_id")[hit], 0u);
  EXPECT_EQ(ids(file, "material_id")[hit], 1u);
  EXPECT_EQ(ids(file, "primitive_id")[8 * 2 + 3], 1u);  // above the diagonal
  EXPECT_EQ(ids(file, "primitive_id")[8 * 5 + 4], 0u);  // below it
  EXPECT_EQ(floats(file, "depth")[0], std::numeric_limits<float>::infinity());
  EXPECT_EQ(floats(file, "normal")[2], 0.0f);
  for (const char* name : {"object_id", "material_id", "primitive_id"}) EXPECT_EQ(ids(file, name)[0], 0xffffffffu);
  EXPECT_EQ(floats(file, "")[3], 0.0f);
}

TEST(RenderReference, AlphaIsTheShareOfSamplesThatHit) {
  Scene scene;
  test::add_black(scene);
  test::add_polygon(scene, {{-9, -9, -1}, {0, -9, -1}, {0, 9, -1}, {-9, 9, -1}});
  scene.environment.sky = scene.environment.ground = glm::vec3(1.0f);
  ReferenceSettings settings = small(16);
  settings.width = settings.height = 3;  // the edge halves the middle column, and 16 samples are stratified
  const std::vector<float> colors = floats(render_reference(scene, Camera{}, settings, {}), "");
  EXPECT_EQ(colors[3], 1.0f);
  EXPECT_EQ(colors[4 + 3], 0.5f);
  EXPECT_EQ(colors[4 + 0], 0.5f);
  EXPECT_EQ(colors[8 + 3], 0.0f);
}

TEST(RenderReference, ThreadsChangeNothing) {
  ReferenceSettings settings = small(4);
  settings.thread_count = 1;
  const ImageFile one = render_reference(floor_scene(), high_camera(), settings, {});
  settings.thread_count = 5;
  const ImageFile five = render_reference(floor_scene(), high_camera(), settings, {});
  for (const Layer& of_one : one.layers) EXPECT_EQ(of_one.values, layer(five, of_one.name).values) << of_one.name;
}

// Within row 3: what was finished is kept, the pixel under way is not.
TEST(RenderReference, CancelledItKeepsThePixelsThatAreDone) {
  ReferenceSettings settings = small(4);
  settings.thread_count = 1;
  const Scene scene = floor_scene();
  const std::size_t done_count = 3 * 24 + 5;
  std::size_t calls = 0;
  ReferenceCallbacks callbacks;
  // One question before each row and each sample.
  callbacks.cancelled = [&] { return ++calls > 4 + 4 * done_count + 2; };
  const ImageFile part = render_reference(scene, high_camera(), settings, callbacks);
  const ImageFile whole = render_reference(scene, high_camera(), settings, {});
  const std::vector<float>&colors = floats(part, ""), &all = floats(whole, "");
  ASSERT_GT(all[4 * done_count + 3], 0.0f);
  for (std::size_t i = 0; i < all.size(); ++i) EXPECT_EQ(colors[i], i < 4 * done_count ? all[i] : 0.0f) << i;
  EXPECT_EQ(ids(part, "object_id").at(done_count - 1), 0u);
  EXPECT_EQ(ids(part, "object_id").at(done_count), 0xFFFFFFFFu);
}

TEST(RenderReference, RefusesSettingsWithoutAnImage) {
  const auto refused = [](auto change) {
    ReferenceSettings settings = small(1);
    change(settings);
    try {
      render_reference(Scene{}, Camera{}, settings, {});
    } catch (const Error& error) {
      return error.kind() == ErrorKind::usage;
    }
    return false;
  };
  EXPECT_TRUE(refused([](ReferenceSettings& s) { s.width = 0; }));
  EXPECT_TRUE(refused([](ReferenceSettings& s) { s.height = -1; }));
  EXPECT_TRUE(refused([](ReferenceSettings& s) { s.spp = 0; }));
  EXPECT_TRUE(refused([](ReferenceSettings& s) { s.cutoff = std::nan(""); }));
  EXPECT_FALSE(refused([](ReferenceSettings&) {}));
}

}  // namespace
}  // namespace vernier
