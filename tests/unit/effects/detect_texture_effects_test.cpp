#include <gtest/gtest.h>

#include "one_triangle.h"

namespace vernier {
namespace {

// One texture in one slot of an otherwise plain material, the effect it asks for, and the factor that rules it out.
struct TextureCase {
  const char* name;
  Workflow workflow;
  int slot;
  std::uint32_t bit;
  void (*rule_out)(Material&);
};

void PrintTo(const TextureCase& texture_case, std::ostream* stream) {
  *stream << texture_case.name;
}

class TextureCounts : public testing::TestWithParam<TextureCase> {};

Scene plain_scene(Workflow workflow) {
  Scene scene = white_triangle();
  Material& material = scene.materials[0];
  material.workflow = workflow;
  material.specular_strength = 1.0f;
  material.roughness = 0.5f;
  material.metallic = 0.5f;
  material.exponent = 10.0f;
  material.ambient = material.emission = material.transmission = glm::vec3(0.5f);
  material.alpha_mode = AlphaMode::blend;
  return scene;
}

TEST_P(TextureCounts, OnlyWhereItsFactorIsNotZero) {
  const TextureCase& texture_case = GetParam();
  Scene scene = plain_scene(texture_case.workflow);
  EXPECT_FALSE(is_on(scene, texture_case.bit)) << "no texture yet";
  add_texture(scene, texture_case.slot);
  EXPECT_TRUE(is_on(scene, texture_case.bit));
  texture_case.rule_out(scene.materials[0]);
  EXPECT_FALSE(is_on(scene, texture_case.bit)) << "the factor is 0";
}

constexpr Workflow kMetal = Workflow::metallic_roughness;
constexpr Workflow kGloss = Workflow::specular_glossiness;
constexpr Workflow kBlinn = Workflow::blinn;

INSTANTIATE_TEST_SUITE_P(
    Slots, TextureCounts,
    testing::Values(TextureCase{"metal_base", kMetal, TEXTURE_SLOT_BASE_COLOR, EFFECT_BASE_COLOR_TEXTURE,
                                [](Material& m) { m.base_color = glm::vec4(0.0f); }},
                    TextureCase{"blinn_base", kBlinn, TEXTURE_SLOT_BASE_COLOR, EFFECT_BASE_COLOR_TEXTURE,
                                [](Material& m) { m.base_color = glm::vec4(0, 0, 0, 1); }},
                    TextureCase{"metal_surface", kMetal, TEXTURE_SLOT_SURFACE, EFFECT_SURFACE_TEXTURE,
                                [](Material& m) { m.roughness = m.metallic = 0.0f; }},
                    TextureCase{"gloss_surface", kGloss, TEXTURE_SLOT_SURFACE, EFFECT_SURFACE_TEXTURE,
                                [](Material& m) {
                                  m.roughness = 1.0f;
                                  m.specular = glm::vec3(0.0f);
                                }},
                    TextureCase{"blinn_surface", kBlinn, TEXTURE_SLOT_SURFACE, EFFECT_SURFACE_TEXTURE,
                                [](Material& m) { m.specular = m.reflection = glm::vec3(0.0f); }},
                    TextureCase{"occlusion", kMetal, TEXTURE_SLOT_OCCLUSION, EFFECT_OCCLUSION_TEXTURE,
                                [](Material& m) { m.occlusion_strength = 0.0f; }},
                    TextureCase{"emission", kMetal, TEXTURE_SLOT_EMISSION, EFFECT_EMISSION_TEXTURE,
                                [](Material& m) { m.emission = glm::vec3(0.0f); }},
                    TextureCase{"transmission", kMetal, TEXTURE_SLOT_TRANSMISSION, EFFECT_OTHER_TEXTURES,
                                [](Material& m) { m.transmission = glm::vec3(0.0f); }},
                    TextureCase{"specular", kMetal, TEXTURE_SLOT_SPECULAR, EFFECT_OTHER_TEXTURES,
                                [](Material& m) { m.specular_strength = 0.0f; }},
                    TextureCase{"specular_color", kMetal, TEXTURE_SLOT_SPECULAR_COLOR, EFFECT_OTHER_TEXTURES,
                                [](Material& m) { m.specular = glm::vec3(0.0f); }},
                    TextureCase{"exponent", kBlinn, TEXTURE_SLOT_SPECULAR, EFFECT_OTHER_TEXTURES,
                                [](Material& m) { m.exponent = 0.0f; }},
                    TextureCase{"ambient", kBlinn, TEXTURE_SLOT_SPECULAR_COLOR, EFFECT_OTHER_TEXTURES,
                                [](Material& m) { m.ambient = glm::vec3(0.0f); }},
                    TextureCase{"alpha", kBlinn, TEXTURE_SLOT_ALPHA, EFFECT_OTHER_TEXTURES,
                                [](Material& m) { m.alpha_mode = AlphaMode::opaque; }}),
    [](const auto& texture_case) { return std::string(texture_case.param.name); });

TEST(TextureEffects, BaseColourTextureCountsForItsAlphaAlone) {
  Scene scene = one_triangle();
  scene.materials[0].alpha_mode = AlphaMode::mask;
  add_texture(scene, TEXTURE_SLOT_BASE_COLOR);
  EXPECT_TRUE(is_on(scene, EFFECT_BASE_COLOR_TEXTURE));
}

TEST(TextureEffects, NormalTextureCountsEvenUnlit) {
  Scene scene = one_triangle();
  EXPECT_FALSE(is_on(scene, EFFECT_NORMAL_TEXTURE));
  add_texture(scene, TEXTURE_SLOT_NORMAL);
  EXPECT_TRUE(is_on(scene, EFFECT_NORMAL_TEXTURE));
  scene.materials[0].unlit = true;
  EXPECT_TRUE(is_on(scene, EFFECT_NORMAL_TEXTURE)) << "the AOV shading_normal shows it";
}

TEST(TextureEffects, OcclusionWithoutAmbientLightIsNone) {
  Scene scene = white_triangle();
  add_texture(scene, TEXTURE_SLOT_OCCLUSION);
  EXPECT_TRUE(is_on(scene, EFFECT_OCCLUSION_TEXTURE));
  scene.environment = Environment{};
  EXPECT_FALSE(is_on(scene, EFFECT_OCCLUSION_TEXTURE));
}

TEST(TextureEffects, UnlitMaterialReadsNoSurface) {
  Scene scene = white_triangle();
  scene.materials[0].unlit = true;
  add_texture(scene, TEXTURE_SLOT_SURFACE);
  add_texture(scene, TEXTURE_SLOT_BASE_COLOR);
  EXPECT_EQ(bits_of(scene), EFFECT_UNLIT | EFFECT_BASE_COLOR_TEXTURE);
}

}  // namespace
}  // namespace vernier
