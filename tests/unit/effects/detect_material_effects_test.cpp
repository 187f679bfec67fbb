#include <gtest/gtest.h>

#include <limits>

#include "one_triangle.h"

namespace vernier {
namespace {

Scene lit_triangle() {
  Scene scene = white_triangle();
  scene.lights = {light_of(LightKind::point)};
  return scene;
}

TEST(DetectReflection, FollowsGlossAndBounces) {
  Scene scene = white_triangle();
  scene.materials[0].specular_strength = 1.0f;
  EXPECT_FALSE(is_on(scene, EFFECT_REFLECTION)) << "roughness 1 has no mirror";
  scene.materials[0].roughness = 0.5f;
  EXPECT_TRUE(is_on(scene, EFFECT_REFLECTION));
  EXPECT_FALSE(is_on(scene, EFFECT_REFLECTION, 0)) << "no bounces";
  scene.materials[0].roughness = std::numeric_limits<float>::quiet_NaN();
  EXPECT_TRUE(is_on(scene, EFFECT_REFLECTION)) << "NaN is never hidden";
}

TEST(DetectReflection, RoughnessTextureMayPolish) {
  Scene scene = white_triangle();
  scene.materials[0].specular_strength = 1.0f;
  add_texture(scene, TEXTURE_SLOT_SURFACE);
  EXPECT_TRUE(is_on(scene, EFFECT_REFLECTION));
}

TEST(DetectReflection, MetalMirrorsWithoutDielectricStrength) {
  Scene scene = white_triangle();
  scene.materials[0].roughness = 0.0f;
  EXPECT_FALSE(is_on(scene, EFFECT_REFLECTION));
  scene.materials[0].metallic = 1.0f;
  EXPECT_TRUE(is_on(scene, EFFECT_REFLECTION));
}

TEST(DetectReflection, RoughMetalMirrorsAsMuchAsItIsGlass) {
  Scene scene = white_triangle();
  scene.materials[0].metallic = 0.5f;
  scene.materials[0].roughness = 1.0f;
  scene.materials[0].ior = 1.0f;
  EXPECT_FALSE(is_on(scene, EFFECT_REFLECTION));
  scene.materials[0].transmission = glm::vec3(0.5f);
  EXPECT_TRUE(is_on(scene, EFFECT_REFLECTION));
}

TEST(DetectReflection, SpecularGlossiness) {
  Scene scene = white_triangle();
  Material& material = scene.materials[0];
  material.workflow = Workflow::specular_glossiness;
  material.roughness = 0.0f;
  EXPECT_TRUE(is_on(scene, EFFECT_REFLECTION));
  material.roughness = 1.0f;
  add_texture(scene, TEXTURE_SLOT_SURFACE);
  EXPECT_FALSE(is_on(scene, EFFECT_REFLECTION)) << "glossiness 0 times a texture is 0";
  material.roughness = 0.0f;
  material.specular = glm::vec3(0.0f);
  EXPECT_FALSE(is_on(scene, EFFECT_REFLECTION));
}

TEST(DetectReflection, Blinn) {
  Scene scene = white_triangle();
  Material& material = scene.materials[0];
  material.workflow = Workflow::blinn;
  EXPECT_FALSE(is_on(scene, EFFECT_REFLECTION));
  material.reflection = glm::vec3(0.0f, 0.0f, 0.25f);
  EXPECT_TRUE(is_on(scene, EFFECT_REFLECTION));
  material.reflection = glm::vec3(0.0f);
  material.fresnel_reflection = true;
  EXPECT_TRUE(is_on(scene, EFFECT_REFLECTION)) << "white at grazing incidence";
}

TEST(DetectRefraction, NeedsTransmissionBaseColourAndBounces) {
  Scene scene = lit_triangle();
  Material& material = scene.materials[0];
  EXPECT_FALSE(is_on(scene, EFFECT_REFRACTION | EFFECT_TINTED_SHADOWS));
  material.transmission = glm::vec3(0.5f);
  EXPECT_TRUE(is_on(scene, EFFECT_REFRACTION));
  EXPECT_TRUE(is_on(scene, EFFECT_TINTED_SHADOWS));
  EXPECT_TRUE(is_on(scene, EFFECT_REFLECTION)) << "the interface reflects";
  EXPECT_FALSE(is_on(scene, EFFECT_REFRACTION, 0));
  EXPECT_TRUE(is_on(scene, EFFECT_TINTED_SHADOWS, 0)) << "shadows pass glass whatever the bounces";
  material.metallic = 1.0f;
  EXPECT_FALSE(is_on(scene, EFFECT_REFRACTION)) << "metal is not transmissive";
  material.metallic = 0.0f;
  material.base_color = glm::vec4(0, 0, 0, 1);
  EXPECT_FALSE(is_on(scene, EFFECT_REFRACTION)) << "the tint is black";
}

TEST(DetectRefraction, BlinnTransmissionStandsAlone) {
  Scene scene = one_triangle();
  scene.materials[0].workflow = Workflow::blinn;
  EXPECT_FALSE(is_on(scene, EFFECT_REFRACTION));
  scene.materials[0].transmission = glm::vec3(0, 1, 0);
  EXPECT_TRUE(is_on(scene, EFFECT_REFRACTION));
}

TEST(DetectAbsorption, NeedsAVolume) {
  Scene scene = lit_triangle();
  Material& material = scene.materials[0];
  material.transmission = glm::vec3(0.5f);
  material.absorption = glm::vec3(0.5f);
  EXPECT_FALSE(is_on(scene, EFFECT_ABSORPTION)) << "thin walls have no inside";
  material.thin_walled = false;
  EXPECT_TRUE(is_on(scene, EFFECT_ABSORPTION));
  EXPECT_TRUE(is_on(scene, EFFECT_ABSORPTION, 0)) << "shadow rays are absorbed without bounces";
  EXPECT_TRUE(is_on(scene, EFFECT_REFRACTION, 0)) << "absorption needs refraction";
  material.absorption = glm::vec3(0.0f);
  EXPECT_FALSE(is_on(scene, EFFECT_ABSORPTION));
}

TEST(DetectAlpha, MaskCountsWhereAlphaCanBeBelowTheCutoff) {
  Scene scene = lit_triangle();
  Material& material = scene.materials[0];
  material.alpha_mode = AlphaMode::mask;
  EXPECT_FALSE(is_on(scene, EFFECT_ALPHA_MASK | EFFECT_TINTED_SHADOWS));
  material.base_color.w = 0.25f;
  EXPECT_TRUE(is_on(scene, EFFECT_ALPHA_MASK));
  EXPECT_TRUE(is_on(scene, EFFECT_TINTED_SHADOWS));
  material.base_color.w = 1.0f;
  add_texture(scene, TEXTURE_SLOT_BASE_COLOR);
  EXPECT_TRUE(is_on(scene, EFFECT_ALPHA_MASK));
}

TEST(DetectAlpha, BlendCountsBelowOne) {
  Scene scene = lit_triangle();
  scene.materials[0].alpha_mode = AlphaMode::blend;
  EXPECT_FALSE(is_on(scene, EFFECT_ALPHA_BLEND | EFFECT_TINTED_SHADOWS));
  scene.materials[0].base_color.w = 0.999f;
  EXPECT_TRUE(is_on(scene, EFFECT_ALPHA_BLEND));
  EXPECT_TRUE(is_on(scene, EFFECT_TINTED_SHADOWS));
  scene.lights.clear();
  EXPECT_FALSE(is_on(scene, EFFECT_TINTED_SHADOWS)) << "no light, no shadow";
}

TEST(DetectAlpha, VertexColoursMayBeTransparent) {
  Scene scene = one_triangle();
  scene.materials[0].alpha_mode = AlphaMode::blend;
  scene.meshes[0].colors.assign(3, glm::vec4(1.0f));
  EXPECT_TRUE(is_on(scene, EFFECT_ALPHA_BLEND));
  EXPECT_TRUE(is_on(scene, EFFECT_VERTEX_COLORS)) << "they scale alpha though the base colour is black";
}

TEST(DetectVertexColors, CountWhereTheyScaleSomething) {
  Scene scene = white_triangle();
  EXPECT_FALSE(is_on(scene, EFFECT_VERTEX_COLORS));
  scene.meshes[0].colors.assign(3, glm::vec4(0.5f));
  EXPECT_TRUE(is_on(scene, EFFECT_VERTEX_COLORS));
  scene.materials[0].base_color = glm::vec4(0, 0, 0, 1);
  EXPECT_FALSE(is_on(scene, EFFECT_VERTEX_COLORS));
}

TEST(DetectVertexColors, TintAmbientLightOfAnMtlMaterial) {
  Scene scene = white_triangle();
  scene.meshes[0].colors.assign(3, glm::vec4(0.5f));
  scene.materials[0].workflow = Workflow::blinn;
  scene.materials[0].base_color = glm::vec4(0, 0, 0, 1);
  EXPECT_FALSE(is_on(scene, EFFECT_VERTEX_COLORS));
  scene.materials[0].ambient = glm::vec3(0.1f);
  EXPECT_TRUE(is_on(scene, EFFECT_VERTEX_COLORS));
}

TEST(DetectSmoothNormals, NeedAllThreeCorners) {
  Scene scene = one_triangle();
  scene.meshes[0].normals.assign(3, glm::vec3(0, 0, 1));
  EXPECT_TRUE(is_on(scene, EFFECT_SMOOTH_NORMALS));
  scene.meshes[0].normals[1] = glm::vec3(0.0f);
  EXPECT_FALSE(is_on(scene, EFFECT_SMOOTH_NORMALS));
}

TEST(DetectSpecular, NeedsALightAndAHighlight) {
  Scene scene = lit_triangle();
  EXPECT_FALSE(is_on(scene, EFFECT_SPECULAR));
  scene.materials[0].specular_strength = 1.0f;
  EXPECT_TRUE(is_on(scene, EFFECT_SPECULAR));
  scene.materials[0].ior = 1.0f;
  EXPECT_FALSE(is_on(scene, EFFECT_SPECULAR)) << "no contrast, no highlight";
  scene.materials[0].ior = 1.5f;
  scene.lights.clear();
  EXPECT_FALSE(is_on(scene, EFFECT_SPECULAR));
}

TEST(DetectAmbient, PolishedMetalLeavesAmbientToItsMirrorRays) {
  Scene scene = white_triangle();
  scene.materials[0].metallic = 1.0f;
  scene.materials[0].roughness = 0.0f;
  EXPECT_FALSE(is_on(scene, EFFECT_AMBIENT));
  scene.materials[0].roughness = 0.5f;
  EXPECT_TRUE(is_on(scene, EFFECT_AMBIENT));
}

TEST(DetectAmbient, RoughGlassMirrorsAllThatItDoesNotLetThrough) {
  Scene scene = white_triangle();
  scene.materials[0].specular_strength = 1.0f;
  scene.materials[0].transmission = glm::vec3(1.0f);
  scene.materials[0].roughness = 0.5f;
  EXPECT_FALSE(is_on(scene, EFFECT_AMBIENT));
  scene.materials[0].transmission = glm::vec3(0.5f);
  EXPECT_TRUE(is_on(scene, EFFECT_AMBIENT));
}

TEST(DetectAmbient, BlinnAsksByItsAmbientColour) {
  Scene scene = white_triangle();
  scene.materials[0].workflow = Workflow::blinn;
  EXPECT_FALSE(is_on(scene, EFFECT_AMBIENT));
  scene.materials[0].ambient = glm::vec3(0.1f);
  EXPECT_TRUE(is_on(scene, EFFECT_AMBIENT));
}

TEST(DetectEmission, FollowsTheFactor) {
  Scene scene = one_triangle();
  EXPECT_FALSE(is_on(scene, EFFECT_EMISSION));
  scene.materials[0].emission = glm::vec3(0, 0, 2);
  EXPECT_TRUE(is_on(scene, EFFECT_EMISSION));
  scene.materials[0].unlit = true;
  EXPECT_FALSE(is_on(scene, EFFECT_EMISSION)) << "unlit materials show their base colour alone";
}

TEST(DetectUnlit, ShowsNothingElse) {
  Scene scene = lit_triangle();
  Material& material = scene.materials[0];
  EXPECT_FALSE(is_on(scene, EFFECT_UNLIT));
  material.unlit = true;
  material.roughness = 0.0f;
  material.specular_strength = 1.0f;
  EXPECT_EQ(bits_of(scene), EFFECT_UNLIT);
}

}  // namespace
}  // namespace vernier
