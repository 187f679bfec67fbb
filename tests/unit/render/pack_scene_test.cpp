#include "render/pack_scene.h"

#include <gtest/gtest.h>

#include <cmath>

#include "bvh/decode_record.h"
#include "error.h"
#include "shader/tiny_scene.h"
#include "shared/bvh_record.h"

namespace vernier {
namespace {

TEST(PackScene, constants_say_what_is_there) {
  const Scene scene = test::tiny_scene();
  const PackedScene packed = pack_scene(scene, 1);
  EXPECT_EQ(packed.steering.light_count, 3u);
  EXPECT_EQ(packed.steering.triangle_count, packed.triangle_count);
  EXPECT_EQ(packed.lights.size(), 3 * sizeof(DeviceLight) / 4);
  EXPECT_EQ(packed.materials.size(), scene.materials.size() * MATERIAL_TEXELS * 4);
  EXPECT_EQ(packed.constants.sky, scene.environment.sky);
  EXPECT_EQ(packed.constants.ground, scene.environment.ground);
  EXPECT_EQ(packed.steering.environment_texture, NONE);
  EXPECT_EQ(packed.constants.metres_per_unit, 2.0f);  // the scene reaches to 1.5 m
}

TEST(PackScene, marks_triangles_that_let_light_pass) {
  const Scene scene = test::tiny_scene();
  const PackedScene packed = pack_scene(scene, 1);
  std::size_t marked = 0;
  for (const BvhRecord& record : packed.bvh.records) {
    if (!is_triangle(record)) continue;
    const std::size_t vertex = BVH_VERTEX_NUMBER(record[3]);
    const std::uint32_t material = packed.vertices[4 * vertex * packed.steering.vertex_texels + 3];
    const bool not_opaque = (record[3] & BVH_TRIANGLE_NOT_OPAQUE) != 0;
    EXPECT_EQ(not_opaque, material >= 2) << material;  // glass, cut-out, pane
    marked += not_opaque ? 1 : 0;
  }
  EXPECT_EQ(marked, 12u + 2 + 1);
}

TEST(PackScene, ray_queries_get_triangles_alone_those_of_every_instance) {
  Scene scene = test::tiny_scene();
  RenderSettings settings;
  settings.sharing = Sharing::always;
  EXPECT_GT(pack_scene(scene, settings).bvh.instance_count, 0u);
  settings.traversal = TraversalForm::ray_query;
  const PackedScene packed = pack_scene(scene, settings);
  EXPECT_EQ(packed.bvh.instance_count, 0u);
  EXPECT_EQ(packed.bvh.records.size(), pack_scene(scene, 1).bvh.triangle_count);
  for (const BvhRecord& record : packed.bvh.records) ASSERT_TRUE(is_triangle(record));
}

TEST(PackScene, a_texture_filter_is_that_of_the_file_again_but_never_the_environment_s) {
  Scene scene;
  const auto texels = test::linear_texels(1, 1, {7});
  for (const std::uint32_t filter : {TEXTURE_FILTER_NEAREST, TEXTURE_FILTER_LINEAR, TEXTURE_FILTER_LINEAR}) {
    test::add_texture(scene, texels, {TEXTURE_WRAP_CLAMP, TEXTURE_WRAP_CLAMP, filter});
  }
  scene.environment.texture = 2;
  PackedScene packed = pack_scene(scene, 1);
  const auto linear_ones = [&](TextureFilter filter) {
    RenderSettings settings = test::small_image(1, 1, 1);
    settings.texture_filter = filter;
    set_settings(packed, settings);
    std::vector<std::uint32_t> are_linear;
    for (const std::size_t word : {3, 7, 11})
      are_linear.push_back((packed.textures[word] >> TEXTURE_FILTER_SHIFT) & 1u);
    return are_linear;
  };
  EXPECT_EQ(linear_ones(TextureFilter::nearest), (std::vector<std::uint32_t>{0, 0, 1}));
  EXPECT_EQ(linear_ones(TextureFilter::linear), (std::vector<std::uint32_t>{1, 1, 1}));
  EXPECT_EQ(linear_ones(TextureFilter::file), (std::vector<std::uint32_t>{0, 1, 1}));
}

TEST(PackScene, an_empty_scene_can_be_packed_and_seen) {
  PackedScene packed = pack_scene(Scene{}, 1);
  EXPECT_EQ(packed.steering.triangle_count, 0u);
  set_camera(packed, test::camera_at(1e6), test::small_image(2, 2, 1));
  EXPECT_EQ(packed.constants.camera_origin.z, 1e6f);
}

TEST(PackScene, the_camera_s_vectors_span_the_image) {
  PackedScene packed;
  packed.space.metres_per_unit = 4.0;
  packed.space.center = {1, 0, 0};
  Camera camera = test::camera_at(8.0, 90.0);
  set_camera(packed, camera, test::small_image(200, 100, 1));
  EXPECT_EQ(packed.constants.camera_origin, glm::vec3(-0.25f, 0, 2));
  EXPECT_FLOAT_EQ(packed.constants.camera_right.x, 2.0f);
  EXPECT_FLOAT_EQ(packed.constants.camera_up.y, 1.0f);
  EXPECT_EQ(packed.constants.camera_forward, glm::vec3(0, 0, -1));
  EXPECT_EQ(packed.steering.orthographic, 0u);
  camera.orthographic = true;
  camera.half_height = 2.0;
  set_camera(packed, camera, test::small_image(200, 100, 1));
  EXPECT_FLOAT_EQ(packed.constants.camera_up.y, 0.5f);
  EXPECT_EQ(packed.steering.orthographic, 1u);
}

TEST(PackScene, a_camera_too_far_to_see_anything_is_refused) {
  PackedScene packed;
  EXPECT_NO_THROW(set_camera(packed, test::camera_at(std::exp2(40)), test::small_image(2, 2, 1)));
  try {
    set_camera(packed, test::camera_at(std::exp2(41)), test::small_image(2, 2, 1));
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::refused);
  }
}

TEST(PackScene, settings_arrive) {
  PackedScene packed;
  RenderSettings settings = test::small_image(30, 20, 5);
  settings.seed = 77;
  settings.max_bounces = 3;
  settings.cutoff = 0.25f;
  set_settings(packed, settings);
  EXPECT_EQ(packed.constants.image_width, 30u);
  EXPECT_EQ(packed.constants.image_height, 20u);
  EXPECT_EQ(packed.constants.seed, 77u);
  EXPECT_EQ(packed.constants.max_bounces, 3u);
  EXPECT_EQ(packed.constants.cutoff, 0.25f);
  EXPECT_EQ(packed.steering.spp, 5u);
}

TEST(PackScene, lights_are_measured_in_units) {
  TracedSpace space;
  space.metres_per_unit = 2.0;
  Light light = test::lamp(LightKind::point, {4, 0, 2}, {0, 0, -1}, 8.0f);
  light.range = 10.0;
  DeviceLight device = device_light(light, space);
  EXPECT_EQ(device.position, glm::vec3(2, 0, 1));
  EXPECT_EQ(device.range, 5.0f);
  EXPECT_EQ(device.intensity, glm::vec3(2.0f));  // intensity / distance^2 stays lux
  light.kind = LightKind::directional;
  EXPECT_EQ(device_light(light, space).intensity, glm::vec3(8.0f));
  light.kind = LightKind::spot;
  light.inner_cone_angle = light.outer_cone_angle = 0.5;
  device = device_light(light, space);
  EXPECT_FLOAT_EQ(device.cos_outer, std::cos(0.5f));
  EXPECT_EQ(device.cone_scale, 1024.0f);
}

}  // namespace
}  // namespace vernier
