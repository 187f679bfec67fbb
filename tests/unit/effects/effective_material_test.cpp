#include "effects/effective_material.h"

#include <gtest/gtest.h>

#include <bit>

#include "one_triangle.h"

namespace vernier {
namespace {

constexpr std::uint32_t kWhite = 0xffffffffu;

/// A 2x1 texture of bytes.
void add_bytes(Scene& scene, int slot, std::uint32_t first, std::uint32_t second,
               std::uint32_t format = TEXTURE_FORMAT_LINEAR8) {
  add_texture(scene, slot);
  scene.textures.back().texels = std::make_shared<Texels>(Texels{format, 2, 1, {first, second}});
}

/// white_triangle with all there is to switch off.
Scene busy_scene() {
  Scene scene = white_triangle();
  scene.materials[0].specular_strength = 1.0f;
  scene.materials[0].roughness = 0.5f;
  scene.materials[0].metallic = 0.5f;
  return scene;
}

TEST(TextureValues, are_those_of_every_texel) {
  Scene scene = busy_scene();
  add_bytes(scene, TEXTURE_SLOT_BASE_COLOR, 0xff00ff00u, 0xff01ff00u);
  scene.textures.push_back({"floats", {}, nullptr});
  const std::uint32_t one = std::bit_cast<std::uint32_t>(1.0f);
  scene.textures.back().texels =
      std::make_shared<Texels>(Texels{TEXTURE_FORMAT_FLOAT, 1, 1, {one, 0, one, 0x3f800001u}});
  const std::vector<TextureValues> values = texture_values(scene, {true, true});
  EXPECT_EQ(values[0].zero, (std::array<bool, 4>{true, false, false, false}));
  EXPECT_EQ(values[0].one, (std::array<bool, 4>{false, true, false, true}));
  EXPECT_EQ(values[1].zero, (std::array<bool, 4>{false, true, false, false}));
  EXPECT_EQ(values[1].one, (std::array<bool, 4>{true, false, true, false}));
  EXPECT_EQ(texture_values(scene, {false, true})[0].one, (std::array<bool, 4>{}));
}

TEST(DetectByValue, a_white_texture_is_none) {
  for (const auto& [slot, bit] : {std::pair{TEXTURE_SLOT_BASE_COLOR, EFFECT_BASE_COLOR_TEXTURE},
                                  {TEXTURE_SLOT_SURFACE, EFFECT_SURFACE_TEXTURE},
                                  {TEXTURE_SLOT_OCCLUSION, EFFECT_OCCLUSION_TEXTURE},
                                  {TEXTURE_SLOT_SPECULAR, EFFECT_OTHER_TEXTURES},
                                  {TEXTURE_SLOT_SPECULAR_COLOR, EFFECT_OTHER_TEXTURES}}) {
    Scene white = busy_scene();
    add_bytes(white, slot, kWhite, kWhite);
    EXPECT_FALSE(is_on(white, bit)) << slot;
    Scene nearly = busy_scene();
    add_bytes(nearly, slot, kWhite, 0xfefefefeu);
    EXPECT_TRUE(is_on(nearly, bit)) << slot;
  }
}

TEST(DetectByValue, a_black_emission_texture_emits_nothing) {
  Scene scene = busy_scene();
  scene.materials[0].emission = glm::vec3(3.0f);
  add_bytes(scene, TEXTURE_SLOT_EMISSION, 0xff000000u, 0xff000000u, TEXTURE_FORMAT_SRGB8);
  EXPECT_FALSE(is_on(scene, EFFECT_EMISSION));
  EXPECT_FALSE(is_on(scene, EFFECT_EMISSION_TEXTURE));
  add_bytes(scene, TEXTURE_SLOT_EMISSION, 0xff000000u, 0xff000100u, TEXTURE_FORMAT_SRGB8);
  EXPECT_TRUE(is_on(scene, EFFECT_EMISSION));
}

TEST(DetectByValue, a_black_transmission_texture_lets_nothing_through) {
  Scene scene = busy_scene();
  scene.materials[0].transmission = glm::vec3(1.0f);
  EXPECT_TRUE(is_on(scene, EFFECT_REFRACTION));
  add_bytes(scene, TEXTURE_SLOT_TRANSMISSION, 0xffffff00u, 0xffffff00u);
  EXPECT_FALSE(is_on(scene, EFFECT_REFRACTION));
  EXPECT_FALSE(is_on(scene, EFFECT_OTHER_TEXTURES));
}

TEST(DetectByValue, a_blended_material_without_a_transparent_texel_is_opaque) {
  Scene scene = busy_scene();
  scene.materials[0].alpha_mode = AlphaMode::blend;
  add_bytes(scene, TEXTURE_SLOT_BASE_COLOR, 0xff102030u, 0xff405060u);
  EXPECT_FALSE(is_on(scene, EFFECT_ALPHA_BLEND));
  EXPECT_TRUE(is_on(scene, EFFECT_BASE_COLOR_TEXTURE));
  scene.meshes[0].colors.assign(3, glm::vec4(1, 1, 1, 0.5f));
  EXPECT_TRUE(is_on(scene, EFFECT_ALPHA_BLEND)) << "vertex colours may be transparent";
  scene.meshes[0].colors.clear();
  scene.materials[0].base_color.w = 0.5f;
  EXPECT_TRUE(is_on(scene, EFFECT_ALPHA_BLEND)) << "the factor is";
  scene.materials[0].alpha_mode = AlphaMode::mask;
  EXPECT_FALSE(is_on(scene, EFFECT_ALPHA_MASK)) << "not below the cutoff of 0.5";
  scene.materials[0].alpha_cutoff = 0.6f;
  EXPECT_TRUE(is_on(scene, EFFECT_ALPHA_MASK));
}

TEST(DetectByValue, the_blue_of_a_surface_texture_says_whether_it_is_metal) {
  Scene scene = busy_scene();
  scene.materials[0].base_color = glm::vec4(0, 0, 0, 1);
  scene.materials[0].specular_strength = 0.0f;
  scene.materials[0].metallic = 1.0f;
  add_bytes(scene, TEXTURE_SLOT_SURFACE, 0xff008000u, 0xff00ff00u);
  EXPECT_FALSE(is_on(scene, EFFECT_REFLECTION)) << "no metal, no dielectric strength";
  add_bytes(scene, TEXTURE_SLOT_SURFACE, 0xff018000u, 0xff00ff00u);
  EXPECT_TRUE(is_on(scene, EFFECT_REFLECTION));
}

}  // namespace
}  // namespace vernier
