#include "effects/detect_effects.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "one_triangle.h"

namespace vernier {
namespace {

TEST(DetectEffects, BlackSceneInTheDarkAsksForNothing) {
  EXPECT_EQ(bits_of(one_triangle()), 0u);
}

TEST(DetectEffects, EmptySceneAsksForNothing) {
  EXPECT_EQ(bits_of(Scene{}), 0u);
}

TEST(DetectEffects, ReasonsListEveryEffectInBitOrderAndAgreeWithBits) {
  Scene scene = white_triangle();
  scene.lights = {light_of(LightKind::spot)};
  const EffectSet effects = detect_effects(scene, Camera{}, 8);
  ASSERT_EQ(effects.reasons.size(), EFFECT_COUNT);
  for (std::uint32_t index = 0; index < EFFECT_COUNT; ++index) {
    const EffectReason& verdict = effects.reasons[index];
    EXPECT_EQ(verdict.bit, 1u << index);
    EXPECT_EQ(verdict.on, (effects.bits & verdict.bit) != 0) << verdict.name;
    EXPECT_FALSE(verdict.reason.empty()) << verdict.name;
    EXPECT_TRUE(std::ranges::all_of(verdict.name, [](char c) { return c == '_' || (c >= 'a' && c <= 'z'); }));
  }
}

TEST(DetectEffects, LightSwitchesItsKindAndShadowsOn) {
  const std::uint32_t kinds = EFFECT_POINT_LIGHTS | EFFECT_SPOT_LIGHTS | EFFECT_DIRECTIONAL_LIGHTS;
  Scene scene = white_triangle();
  scene.lights = {light_of(LightKind::point)};
  EXPECT_EQ(bits_of(scene) & (kinds | EFFECT_SHADOWS), EFFECT_POINT_LIGHTS | EFFECT_SHADOWS);
  scene.lights = {light_of(LightKind::directional)};
  EXPECT_EQ(bits_of(scene) & (kinds | EFFECT_SHADOWS), EFFECT_DIRECTIONAL_LIGHTS | EFFECT_SHADOWS);
  scene.lights = {light_of(LightKind::spot)};
  EXPECT_EQ(bits_of(scene) & (kinds | EFFECT_SHADOWS), EFFECT_POINT_LIGHTS | EFFECT_SPOT_LIGHTS | EFFECT_SHADOWS);
}

TEST(DetectEffects, LightThatChangesNothingIsNone) {
  Scene dark = white_triangle();
  dark.lights = {light_of(LightKind::point)};
  dark.lights[0].intensity = glm::vec3(0.0f);
  EXPECT_FALSE(is_on(dark, EFFECT_POINT_LIGHTS | EFFECT_SHADOWS));
  Scene short_range = white_triangle();
  short_range.lights = {light_of(LightKind::point)};
  short_range.lights[0].range = 0.0;
  EXPECT_FALSE(is_on(short_range, EFFECT_POINT_LIGHTS | EFFECT_SHADOWS));
  Scene black = one_triangle();
  black.lights = {light_of(LightKind::point)};
  EXPECT_FALSE(is_on(black, EFFECT_POINT_LIGHTS | EFFECT_SHADOWS));
  Scene unlit = white_triangle();
  unlit.materials[0].unlit = true;
  unlit.lights = {light_of(LightKind::directional)};
  EXPECT_FALSE(is_on(unlit, EFFECT_DIRECTIONAL_LIGHTS | EFFECT_SHADOWS));
}

TEST(DetectEffects, NegativeLightCounts) {
  Scene scene = white_triangle();
  scene.lights = {light_of(LightKind::point)};
  scene.lights[0].intensity = glm::vec3(-1.0f, 0.0f, 0.0f);
  EXPECT_TRUE(is_on(scene, EFFECT_POINT_LIGHTS));
}

TEST(DetectEffects, AmbientNeedsASourceAndASurface) {
  EXPECT_TRUE(is_on(white_triangle(), EFFECT_AMBIENT));
  Scene black_override = white_triangle();
  black_override.environment.has_ambient_override = true;
  EXPECT_FALSE(is_on(black_override, EFFECT_AMBIENT));
  Scene override_in_the_dark = white_triangle();
  override_in_the_dark.environment = Environment{};
  override_in_the_dark.environment.has_ambient_override = true;
  override_in_the_dark.environment.ambient = glm::vec3(0.0f, 0.1f, 0.0f);
  EXPECT_TRUE(is_on(override_in_the_dark, EFFECT_AMBIENT));
  Scene black_surface = one_triangle();
  black_surface.environment.sky = glm::vec3(1.0f);
  EXPECT_FALSE(is_on(black_surface, EFFECT_AMBIENT));
}

TEST(DetectEffects, EnvironmentImageCountsUnlessScaledToBlack) {
  Scene scene = one_triangle();
  scene.textures.push_back(Texture{"sky", {}, nullptr});
  scene.environment.texture = 0;
  EXPECT_TRUE(is_on(scene, EFFECT_ENVIRONMENT_MAP));
  scene.environment.texture_scale = glm::vec3(0.0f);
  EXPECT_FALSE(is_on(scene, EFFECT_ENVIRONMENT_MAP));
}

TEST(DetectEffects, OrthographicFollowsTheCamera) {
  Camera camera;
  EXPECT_EQ(detect_effects(one_triangle(), camera, 8).bits & EFFECT_ORTHOGRAPHIC, 0u);
  camera.orthographic = true;
  EXPECT_EQ(detect_effects(one_triangle(), camera, 8).bits, EFFECT_ORTHOGRAPHIC);
}

TEST(DetectEffects, ReasonNamesMaterialLightAndTexture) {
  Scene scene = white_triangle();
  scene.lights = {light_of(LightKind::point)};
  add_texture(scene, TEXTURE_SLOT_BASE_COLOR);
  const EffectSet effects = detect_effects(scene, Camera{}, 8);
  EXPECT_EQ(reason_for(effects, EFFECT_POINT_LIGHTS), "light 0 (lamp) falls on material 0 (paint)");
  EXPECT_EQ(reason_for(effects, EFFECT_BASE_COLOR_TEXTURE), "material 0 (paint): base colour texture 0 (checker)");
}

std::string reason_without(const Scene& scene, std::uint32_t bit, int max_bounces = 8) {
  return reason_for(detect_effects(scene, Camera{}, max_bounces), bit);
}

TEST(ReasonForOff, NamesTheLightThatDoesNotShine) {
  Scene scene = white_triangle();
  scene.lights = {light_of(LightKind::point)};
  scene.lights[0].intensity = glm::vec3(0.0f);
  EXPECT_EQ(reason_without(scene, EFFECT_POINT_LIGHTS), "light 0 (lamp): its intensity is 0");
  scene.lights[0].intensity = glm::vec3(1.0f);
  scene.lights[0].position = glm::dvec3(0, 0, 8);
  scene.lights[0].range = 2.5;
  EXPECT_EQ(reason_without(scene, EFFECT_SHADOWS), "light 0 (lamp): its range of 2.5 m ends before every triangle");
}

TEST(ReasonForOff, NamesTheMaterialThatNoTriangleUses) {
  Scene scene = white_triangle();
  Material glass = scene.materials[0];
  glass.name = "glass";
  glass.transmission = glm::vec3(0.5f);
  scene.materials.push_back(glass);
  EXPECT_EQ(reason_without(scene, EFFECT_REFRACTION),
            "material 1 (glass): transmission 0.5, 0.5, 0.5; but no triangle uses it");
}

TEST(ReasonForOff, NamesTheMaterialThatBouncesWouldShow) {
  Scene scene = white_triangle();
  scene.materials[0].transmission = glm::vec3(0.5f);
  EXPECT_EQ(reason_without(scene, EFFECT_REFRACTION, 0),
            "material 0 (paint): transmission 0.5, 0.5, 0.5; but no bounces are allowed");
}

TEST(ReasonForOff, NamesTheTextureThatSaysNothing) {
  Scene scene = white_triangle();
  add_texture(scene, TEXTURE_SLOT_BASE_COLOR);
  scene.textures[0].texels = std::make_shared<Texels>(Texels{TEXTURE_FORMAT_SRGB8, 1, 1, {~0u}});
  EXPECT_EQ(reason_without(scene, EFFECT_BASE_COLOR_TEXTURE),
            "material 0 (paint): base colour texture 0 (checker); but its texels leave nothing of it");
}

TEST(ReasonForOff, IsOfEverythingWhereNothingInTheFileAsks) {
  EXPECT_EQ(reason_without(white_triangle(), EFFECT_REFRACTION), "transmission 0 on all visible triangles");
}

}  // namespace
}  // namespace vernier
