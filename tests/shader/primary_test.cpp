#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "shader/shader.h"
#include "shader/tiny_scene.h"

namespace vernier::shader {
namespace {

/// The AOVs of one pixel.
struct Aovs {
  std::vector<std::uint32_t> words;
  float number(uint i) const { return glm::uintBitsToFloat(words.at(i)); }
  vec3 vector(uint i) const { return {number(i), number(i + 1), number(i + 2)}; }
};

/// What the ray along -Z through the middle of an image sees from `camera`; the pixel is the third of its band.
Aovs middle_of(const Scene& scene, const Camera& camera) {
  const PackedScene packed = test::packed_for(scene, camera, test::small_image(1, 1, 1));
  Memory memory_of_scene = memory_of(packed);
  const BoundMemory bound(memory_of_scene);
  memory_of_scene.aovs.assign(std::size_t{4} * AOV_WORDS, 0xdeadu);
  trace_primary(vec2(0.5f), 2u);
  const auto first = memory_of_scene.aovs.begin() + 2 * AOV_WORDS, last = first + AOV_WORDS;
  EXPECT_EQ(std::count(memory_of_scene.aovs.begin(), first, 0xdeadu), 2 * AOV_WORDS);
  EXPECT_EQ(std::count(last, memory_of_scene.aovs.end(), 0xdeadu), std::ptrdiff_t{AOV_WORDS});
  return {{first, last}};
}

/// A square of a mesh and a material of its own at height z: red 0.5, green 0.25, blue 1.
Mesh& add_painted_square(Scene& scene, float z, float alpha = 1.0f, AlphaMode mode = AlphaMode::opaque) {
  Material& paint = test::add_black(scene);
  paint.base_color = glm::vec4(0.5f, 0.25f, 1.0f, alpha);
  paint.alpha_mode = mode;
  return test::add_square(scene, z);
}

TEST(Primary, a_square_by_hand) {
  Scene scene;
  add_painted_square(scene, 0.0f);
  Camera camera = test::camera_at(2);
  camera.world_from_camera[3] = glm::dvec4(0.5, -0.25, 2, 1);
  const Aovs aovs = middle_of(scene, camera);
  // The ray through the middle is -Z itself, and all numbers are short: no rounding.
  EXPECT_EQ(aovs.number(AOV_DEPTH), 2.0f);
  EXPECT_EQ(aovs.vector(AOV_POSITION), vec3(0.5f, -0.25f, 0));
  EXPECT_EQ(aovs.vector(AOV_NORMAL), vec3(0, 0, 1));
  EXPECT_EQ(aovs.vector(AOV_SHADING_NORMAL), vec3(0, 0, 1));
  EXPECT_EQ(aovs.number(AOV_UV), 0.75f);
  EXPECT_EQ(aovs.number(AOV_UV + 1), 0.375f);
  EXPECT_EQ(aovs.vector(AOV_ALBEDO), vec3(0.5f, 0.25f, 1));
  EXPECT_EQ(aovs.words[AOV_OBJECT_ID], 0u);
  EXPECT_EQ(aovs.words[AOV_MATERIAL_ID], 0u);
  EXPECT_EQ(aovs.words[AOV_PRIMITIVE_ID], 0u);  // the lower right half
  EXPECT_EQ(aovs.words[AOV_TRIANGLE], 0u);
}

TEST(Primary, ids_are_the_instance_s_and_the_triangle_s_within_its_mesh) {
  Scene scene;
  add_painted_square(scene, -3.0f);
  add_painted_square(scene, -1.0f);
  Camera camera = test::camera_at(2);
  camera.world_from_camera[3] = glm::dvec4(-0.5, 0.25, 2, 1);
  const Aovs aovs = middle_of(scene, camera);
  EXPECT_EQ(aovs.number(AOV_DEPTH), 3.0f);
  EXPECT_EQ(aovs.words[AOV_OBJECT_ID], 1u);
  EXPECT_EQ(aovs.words[AOV_MATERIAL_ID], 1u);
  EXPECT_EQ(aovs.words[AOV_PRIMITIVE_ID], 1u);  // the upper left half
  EXPECT_EQ(aovs.words[AOV_TRIANGLE], 3u);
}

TEST(Primary, lengths_are_metres_of_the_world_whatever_the_traced_space) {
  Scene scene;
  add_painted_square(scene, 0.0f);
  scene.instances[0].world_from_object[3] = glm::dvec4(96, 0, -4096, 1);
  scene.instances[0].world_from_object[0][0] = scene.instances[0].world_from_object[1][1] = 32;
  Camera camera = test::camera_at(2);
  camera.world_from_camera[3] = glm::dvec4(104, 8, -4000, 1);
  const Aovs aovs = middle_of(scene, camera);
  EXPECT_EQ(aovs.number(AOV_DEPTH), 96.0f);
  EXPECT_EQ(aovs.vector(AOV_POSITION), vec3(104, 8, -4096));
  EXPECT_EQ(aovs.number(AOV_UV), 0.625f);
  EXPECT_EQ(aovs.number(AOV_UV + 1), 0.625f);
}

TEST(Primary, from_behind_both_normals_turn_to_the_viewer) {
  Scene scene;
  Mesh& square = add_painted_square(scene, 0.0f);
  square.normals.assign(4, glm::vec3(0.6f, 0, 0.8f));
  const auto seen_from = [&](double z) {
    Camera camera = test::camera_at(z);
    if (z < 0) camera.world_from_camera[0][0] = camera.world_from_camera[2][2] = -1;  // looks along +Z
    camera.world_from_camera[3].x = 0.5;                                              // not on the diagonal
    return middle_of(scene, camera);
  };
  const Aovs front = seen_from(2), back = seen_from(-2);
  EXPECT_EQ(front.vector(AOV_NORMAL), vec3(0, 0, 1));
  EXPECT_EQ(back.vector(AOV_NORMAL), vec3(0, 0, -1));
  EXPECT_EQ(back.vector(AOV_SHADING_NORMAL), -front.vector(AOV_SHADING_NORMAL));
  EXPECT_NEAR(front.vector(AOV_SHADING_NORMAL).x, 0.6f, 4 * 0x1p-24f);  // unit_vector of the weighted sum
}

TEST(Primary, nothing_is_infinitely_far_and_has_no_ids) {
  Scene scene;
  add_painted_square(scene, 0.0f);
  Camera camera = test::camera_at(2);
  camera.world_from_camera[3].x = 5;
  for (const Scene& seen : {scene, Scene()}) {
    const Aovs aovs = middle_of(seen, camera);
    EXPECT_EQ(aovs.number(AOV_DEPTH), std::numeric_limits<float>::infinity());
    for (uint i = AOV_POSITION; i < AOV_OBJECT_ID; ++i) EXPECT_EQ(aovs.words[i], 0u) << i;
    for (uint i = AOV_OBJECT_ID; i < AOV_WORDS; ++i) EXPECT_EQ(aovs.words[i], NONE) << i;
  }
}

TEST(Primary, cut_out_and_clear_layers_are_passed) {
  Scene scene;
  add_painted_square(scene, 0.0f);
  for (int i = 1; i <= 20; ++i) {
    add_painted_square(scene, 0.0625f * static_cast<float>(i), 0.25f, AlphaMode::mask);  // the cutoff is 0.5
    add_painted_square(scene, 0.0625f * static_cast<float>(i), 0.0f, AlphaMode::blend);  // at the same place
  }
  Camera camera = test::camera_at(2);
  camera.world_from_camera[3].x = 0.5;
  EXPECT_EQ(middle_of(scene, camera).words[AOV_OBJECT_ID], 0u);
  scene.materials[15].base_color.a = 0.125f;  // a pane that is seen at all
  EXPECT_EQ(scene.materials[15].alpha_mode, AlphaMode::mask);
  EXPECT_EQ(middle_of(scene, camera).words[AOV_OBJECT_ID], 0u) << "below the cutoff";
  scene.materials[15].base_color.a = 0.5f;
  EXPECT_EQ(middle_of(scene, camera).words[AOV_OBJECT_ID], 15u) << "at the cutoff";
  scene.materials[20].base_color.a = 0.125f;
  EXPECT_EQ(middle_of(scene, camera).words[AOV_OBJECT_ID], 20u) << "blend counts from the first trace of it";
}

TEST(Primary, of_triangles_in_one_place_the_lowest_is_seen) {
  Scene scene;
  for (int i = 0; i < 5; ++i) add_painted_square(scene, 0.0f, i < 2 ? 0.0f : 1.0f, AlphaMode::mask);
  Camera camera = test::camera_at(2);
  camera.world_from_camera[3].x = 0.5;
  EXPECT_EQ(middle_of(scene, camera).words[AOV_OBJECT_ID], 2u);
}

TEST(Primary, the_albedo_has_texture_and_vertex_colour_in_it) {
  Scene scene;
  Mesh& square = add_painted_square(scene, 0.0f);
  square.colors.assign(4, glm::vec4(0.5f, 1, 0.25f, 1));
  scene.materials[0].textures[TEXTURE_SLOT_BASE_COLOR].texture =
      test::add_texture(scene, test::linear_texels(1, 1, {0xffff00ff}));
  Camera camera = test::camera_at(2);
  camera.world_from_camera[3].x = 0.5;
  EXPECT_EQ(middle_of(scene, camera).vector(AOV_ALBEDO), vec3(0.25f, 0, 0.25f));
}

}  // namespace
}  // namespace vernier::shader
