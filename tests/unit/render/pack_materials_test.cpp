#include "render/pack_materials.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstring>

#include "shared/render_constants.h"
#include "unit/reference/test_scenes.h"

namespace vernier {
namespace {

TEST(PackMaterials, every_field_arrives) {
  Material material;
  material.base_color = {0.1f, 0.2f, 0.3f, 0.4f};
  material.specular = {1, 2, 3};
  material.specular_strength = 0.9f;
  material.metallic = 0.6f;
  material.roughness = 0.7f;
  material.exponent = 33.0f;
  material.reflection = {4, 5, 6};
  material.emission = {7, 8, 9};
  material.transmission = {10, 11, 12};
  material.ior = 1.4f;
  material.absorption = {2, 4, 6};
  material.ambient = {16, 17, 18};
  material.alpha_cutoff = 0.3f;
  material.normal_scale = 0.8f;
  material.occlusion_strength = 0.2f;
  material.textures[TEXTURE_SLOT_NORMAL].texture = 0;
  material.textures[TEXTURE_SLOT_ALPHA].texture = 3;
  const DeviceMaterial device = device_material(material, 0.5);
  EXPECT_EQ(device.base_color, material.base_color);
  EXPECT_EQ(device.specular, material.specular);
  EXPECT_EQ(device.specular_strength, 0.9f);
  EXPECT_EQ(device.metallic, 0.6f);
  EXPECT_EQ(device.roughness, 0.7f);
  EXPECT_EQ(device.reflection, material.reflection);
  EXPECT_EQ(device.emission, material.emission);
  EXPECT_EQ(device.transmission, material.transmission);
  EXPECT_EQ(device.ior, 1.4f);
  EXPECT_EQ(device.absorption, glm::vec3(1, 2, 3));
  EXPECT_EQ(device.ambient, material.ambient);
  EXPECT_EQ(device.alpha_cutoff, 0.3f);
  EXPECT_EQ(device.normal_scale, 0.8f);
  EXPECT_EQ(device.occlusion_strength, 0.2f);
  EXPECT_EQ(device.textured_slots, 1u << TEXTURE_SLOT_NORMAL | 1u << TEXTURE_SLOT_ALPHA);
  material.workflow = Workflow::blinn;
  EXPECT_EQ(device_material(material, 1.0).roughness, 33.0f);
}

TEST(PackMaterials, flags_by_bit) {
  Material material;
  material.thin_walled = false;
  EXPECT_EQ(device_material(material, 1.0).flags, WORKFLOW_METALLIC_ROUGHNESS);
  material.workflow = Workflow::blinn;
  material.alpha_mode = AlphaMode::blend;
  EXPECT_EQ(device_material(material, 1.0).flags, WORKFLOW_BLINN | ALPHA_BLEND << MATERIAL_ALPHA_SHIFT);
  material.unlit = material.thin_walled = material.fresnel_reflection = true;
  EXPECT_EQ(device_material(material, 1.0).flags, WORKFLOW_BLINN | ALPHA_BLEND << MATERIAL_ALPHA_SHIFT |
                                                      MATERIAL_UNLIT | MATERIAL_THIN_WALLED |
                                                      MATERIAL_FRESNEL_REFLECTION);
}

TEST(PackMaterials, unlit_lets_no_light_through) {
  Material material;
  material.transmission = glm::vec3(1);
  material.unlit = true;
  EXPECT_EQ(device_material(material, 1.0).transmission, glm::vec3(0));
}

TEST(PackMaterials, texture_uses_follow_their_material) {
  Scene scene;
  scene.textures.resize(5);
  scene.materials.resize(2);
  TextureUse& use = scene.materials[1].textures[TEXTURE_SLOT_EMISSION];
  use.texture = 4;
  use.uv_set = 2;
  use.uv_from_vertex_uv = glm::mat3x2(1, 2, 3, 4, 5, 6);
  const std::vector<std::uint32_t> words = pack_materials(scene, 1.0);
  ASSERT_EQ(words.size(), 2 * MATERIAL_TEXELS * 4);
  DeviceTextureUse packed;
  const std::size_t texel = MATERIAL_TEXELS + MATERIAL_OWN_TEXELS + TEXTURE_USE_TEXELS * TEXTURE_SLOT_EMISSION;
  std::memcpy(&packed, words.data() + 4 * texel, sizeof(packed));
  EXPECT_EQ(packed.texture, 4u);
  EXPECT_EQ(packed.uv_set, 2u);
  // u' = m00 u + m01 v + m02.
  EXPECT_EQ(packed.m00, 1.0f);
  EXPECT_EQ(packed.m10, 2.0f);
  EXPECT_EQ(packed.m01, 3.0f);
  EXPECT_EQ(packed.m11, 4.0f);
  EXPECT_EQ(packed.m02, 5.0f);
  EXPECT_EQ(packed.m12, 6.0f);
  std::memcpy(&packed, words.data() + 4 * MATERIAL_OWN_TEXELS, sizeof(packed));
  EXPECT_EQ(packed.texture, NONE);
}

TEST(PackTextures, shared_texels_lie_there_once_after_the_srgb_curve) {
  Scene scene;
  const auto texels = test::linear_texels(2, 1, {11, 12});
  Sampler clamped{TEXTURE_WRAP_CLAMP, TEXTURE_WRAP_MIRROR, TEXTURE_FILTER_NEAREST};
  test::add_texture(scene, texels);
  test::add_texture(scene, test::linear_texels(1, 3, {21, 22, 23}));
  test::add_texture(scene, texels, clamped);
  const PackedTextures packed = pack_textures(scene);
  ASSERT_EQ(packed.texels.size(), SRGB_CURVE_WORDS + 8u) << "each from a multiple of 4 on";
  EXPECT_EQ(texel_words(scene), 8u);
  EXPECT_EQ(packed.texels[SRGB_CURVE_WORDS + 1], 12u);
  EXPECT_EQ(packed.texels[SRGB_CURVE_WORDS + 4], 21u);
  const std::uint32_t linear = TEXTURE_FORMAT_LINEAR8 | TEXTURE_FILTER_LINEAR << TEXTURE_FILTER_SHIFT |
                               TEXTURE_FILTER_LINEAR << TEXTURE_FILE_FILTER_SHIFT;
  const std::uint32_t nearest =
      TEXTURE_FORMAT_LINEAR8 | TEXTURE_WRAP_CLAMP << TEXTURE_WRAP_U_SHIFT | TEXTURE_WRAP_MIRROR << TEXTURE_WRAP_V_SHIFT;
  EXPECT_EQ(packed.textures, (std::vector<std::uint32_t>{2, 1, 256, linear, 1, 3, 260, linear, 2, 1, 256, nearest}));
}

TEST(PackTextures, the_srgb_curve_is_iec_61966) {
  const PackedTextures packed = pack_textures(Scene{});
  ASSERT_EQ(packed.texels.size(), std::size_t{SRGB_CURVE_WORDS});
  const auto value = [&](std::size_t byte) { return std::bit_cast<float>(packed.texels[byte]); };
  EXPECT_EQ(value(0), 0.0f);
  EXPECT_EQ(value(255), 1.0f);
  EXPECT_FLOAT_EQ(value(10), 10 / 255.0f / 12.92f);
  EXPECT_NEAR(value(128), 0.21586, 1e-5);
  EXPECT_NEAR(value(188), 0.50289, 1e-5);
}

}  // namespace
}  // namespace vernier
