#include "reference/surface_terms.h"

#include <gtest/gtest.h>

#include <numbers>

#include "test_scenes.h"

namespace vernier::reference {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kFloat = 1e-6;  // the material's numbers are floats

void expect_near(const glm::dvec3& a, const glm::dvec3& b) {
  EXPECT_LT(glm::distance(a, b), kFloat) << a.x << ' ' << a.y << ' ' << a.z;
}

Scene scene_of(const Material& material) {
  Scene scene;
  scene.materials.push_back(material);
  test::add_square(scene, 0.0f);
  return scene;
}

SurfaceTerms terms_of(const Scene& scene) {
  return surface_terms(scene, bake_triangles(scene).triangles[0], glm::dvec3(0.5, 0.25, 0.25));
}

TEST(SurfaceTerms, RoughDielectric) {
  Material material;
  material.base_color = {0.8f, 0.4f, 0.2f, 1.0f};
  const SurfaceTerms terms = terms_of(scene_of(material));
  expect_near(terms.diffuse, 0.96 * glm::dvec3(0.8, 0.4, 0.2));
  EXPECT_NEAR(terms.exponent, 0.0, kFloat);
  expect_near(terms.specular, glm::dvec3(0.04 * 2.0 / (8.0 * kPi)));
  expect_near(terms.mirror_normal, glm::dvec3(0.0));
  expect_near(terms.mirror_grazing, glm::dvec3(0.0));
  expect_near(terms.ambient, 0.96 * glm::dvec3(0.8, 0.4, 0.2) + 0.04);
  expect_near(terms.transmission, glm::dvec3(0.0));
  EXPECT_TRUE(terms.cosine);
}

TEST(SurfaceTerms, MetalOfRoughnessOneHalf) {
  Material material;
  material.base_color = {0.8f, 0.4f, 0.2f, 1.0f};
  material.metallic = 1.0f;
  material.roughness = 0.5f;
  const glm::dvec3 base(0.8, 0.4, 0.2);
  const SurfaceTerms terms = terms_of(scene_of(material));
  expect_near(terms.diffuse, glm::dvec3(0.0));
  EXPECT_NEAR(terms.exponent, 30.0, kFloat);  // alpha = 1/4
  expect_near(terms.specular, base * (32.0 / (8.0 * kPi)));
  expect_near(terms.mirror_normal, base * 0.25);
  expect_near(terms.mirror_grazing, glm::dvec3(0.25));
  expect_near(terms.ambient, base * 0.75);
}

TEST(SurfaceTerms, SpecularExtensionScalesF0AndF90) {
  Material material;
  material.roughness = 0.0f;
  material.specular_strength = 0.5f;
  material.specular = {1.0f, 0.5f, 100.0f};
  const SurfaceTerms terms = terms_of(scene_of(material));
  expect_near(terms.mirror_normal, {0.02, 0.01, 0.5});  // the last: min(4, 1) / 2
  expect_near(terms.mirror_grazing, glm::dvec3(0.5));
  expect_near(terms.diffuse, glm::dvec3(0.5));
  EXPECT_NEAR(terms.exponent, 2.0 * 1024.0 - 2.0, kFloat);  // alpha is at least 2^-5
}

TEST(SurfaceTerms, TransmissionTakesFromTheDiffusePart) {
  Material material;
  material.base_color = {0.8f, 0.4f, 0.2f, 1.0f};
  material.transmission = glm::vec3(0.75f);
  material.metallic = 0.5f;
  const glm::dvec3 base(0.8, 0.4, 0.2);
  const SurfaceTerms terms = terms_of(scene_of(material));
  expect_near(terms.transmission, base * 0.75 * 0.5);
  expect_near(terms.diffuse, base * 0.5 * 0.25 * 0.96);
  // Roughness 1 mirrors as much as is clear.
  expect_near(terms.mirror_normal, (0.02 + 0.5 * base) * 0.375);
  EXPECT_NEAR(terms.withheld_normal, 0.04, kFloat);
  EXPECT_NEAR(terms.withheld_grazing, 1.0, kFloat);
  EXPECT_NEAR(passed_share(terms, 0.04, 1.5), 0.96, kFloat);
  EXPECT_NEAR(passed_share(terms, 0.52, 1.5), 0.48, kFloat);
  EXPECT_EQ(passed_share(terms, 1.0, 1.5), 0.0);
}

TEST(SurfaceTerms, MetallicRoughnessTextures) {
  Material material;
  Scene scene = scene_of(material);
  // r 0.2, g 0.4, b 0.6, a 0.8
  const int texture = test::add_texture(scene, test::linear_texels(1, 1, {0xcc996633u}));
  for (const int slot :
       {TEXTURE_SLOT_SURFACE, TEXTURE_SLOT_SPECULAR, TEXTURE_SLOT_TRANSMISSION, TEXTURE_SLOT_OCCLUSION})
    scene.materials[0].textures[slot].texture = texture;
  scene.materials[0].metallic = 0.5f;
  scene.materials[0].transmission = glm::vec3(0.5f);
  scene.materials[0].occlusion_strength = 0.5f;
  const SurfaceTerms terms = terms_of(scene);
  const double metal = 0.3;
  const double f0 = 0.04 * 0.8 * 0.7 + metal;
  const double gloss = 1.0 - 0.64 * (1.0 - 0.07);  // roughness 0.4, a tenth of what is no metal is clear
  const double diffuse = 0.7 * 0.9 * (1.0 - 0.04 * 0.8);
  expect_near(terms.mirror_normal, glm::dvec3(f0 * gloss));
  expect_near(terms.mirror_grazing, glm::dvec3((0.8 * 0.7 + metal) * gloss));
  expect_near(terms.transmission, glm::dvec3(0.7 * 0.1));
  expect_near(terms.diffuse, glm::dvec3(diffuse));
  expect_near(terms.ambient, glm::dvec3((diffuse + f0 * (1.0 - gloss)) * 0.6));
}

TEST(SurfaceTerms, SpecularGlossiness) {
  Material material;
  material.workflow = Workflow::specular_glossiness;
  material.base_color = {0.5f, 0.5f, 0.5f, 1.0f};
  material.specular = {0.2f, 0.4f, 3.0f};
  material.roughness = 0.25f;
  Scene scene = scene_of(material);
  SurfaceTerms terms = terms_of(scene);
  expect_near(terms.mirror_normal, glm::dvec3(0.2, 0.4, 1.0) * 0.5625);
  expect_near(terms.mirror_grazing, glm::dvec3(0.5625));
  expect_near(terms.diffuse, glm::dvec3(0.0));
  scene.materials[0].specular = glm::vec3(0.0f);
  terms = terms_of(scene);
  expect_near(terms.mirror_grazing, glm::dvec3(0.0));
  expect_near(terms.diffuse, glm::dvec3(0.5));
  scene.materials[0].specular = glm::vec3(1.0f);
  const int texture =
      test::add_texture(scene, test::linear_texels(1, 1, {0x80ff3366u}));  // r 0.4, g 0.2, b 1, a 128/255
  scene.materials[0].textures[TEXTURE_SLOT_SURFACE].texture = texture;
  const double gloss = 0.75 * 128.0 / 255.0;
  expect_near(terms_of(scene).mirror_normal, glm::dvec3(0.4, 0.2, 1.0) * gloss * gloss);
}

TEST(SurfaceTerms, BlinnIsTheMtlText) {
  Material material;
  material.workflow = Workflow::blinn;
  material.base_color = {0.5f, 0.6f, 0.7f, 0.3f};
  material.specular = {0.1f, 0.2f, 0.3f};
  material.exponent = 40.0f;
  material.ambient = glm::vec3(0.25f);
  material.reflection = glm::vec3(0.5f);
  material.transmission = {0.0f, 1.0f, 0.5f};
  material.emission = {3.0f, 2.0f, 1.0f};
  Scene scene = scene_of(material);
  SurfaceTerms terms = terms_of(scene);
  expect_near(terms.diffuse, {0.5, 0.6, 0.7});
  expect_near(terms.specular, glm::dvec3(0.1, 0.2, 0.3) / kPi);
  EXPECT_DOUBLE_EQ(terms.exponent, 40.0);
  EXPECT_FALSE(terms.cosine);
  EXPECT_TRUE(terms.plain_mirror);
  expect_near(terms.ambient, glm::dvec3(0.25));
  expect_near(terms.mirror_normal, glm::dvec3(0.5));
  expect_near(terms.mirror_grazing, glm::dvec3(0.5));
  expect_near(terms.transmission, {0, 1, 0.5});
  expect_near(terms.emission, {3, 2, 1});
  scene.materials[0].fresnel_reflection = true;
  terms = terms_of(scene);
  expect_near(terms.mirror_grazing, glm::dvec3(1.0));
  EXPECT_FALSE(terms.plain_mirror);
}

TEST(SurfaceTerms, VertexColoursMultiplyTheBase) {
  Scene scene = scene_of(Material{});
  scene.meshes[0].colors = {{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}, {0, 0, 0, 1}};
  expect_near(terms_of(scene).base, {0.5, 0.25, 0.25});
}

TEST(SurfaceTerms, UvTransformAndSet) {
  Scene scene = scene_of(Material{});
  scene.meshes[0].uvs[2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};  // the point of terms_of: (0.5, 0.25)
  const int texture = test::add_texture(scene, test::linear_texels(2, 1, {0xff000000u, 0xff0000ffu}),
                                        {TEXTURE_WRAP_REPEAT, TEXTURE_WRAP_REPEAT, TEXTURE_FILTER_NEAREST});
  TextureUse use{texture, 2, glm::mat3x2(1.0f)};
  use.uv_from_vertex_uv = glm::mat3x2(0, 0, 1, 0, 0.5f, 0);  // u' = v + 1/2
  scene.materials[0].textures[TEXTURE_SLOT_BASE_COLOR] = use;
  EXPECT_DOUBLE_EQ(terms_of(scene).base.x, 1.0);
  scene.materials[0].textures[TEXTURE_SLOT_BASE_COLOR].uv_set = 1;  // none: (0, 0), u' = 1/2
  EXPECT_DOUBLE_EQ(terms_of(scene).base.x, 1.0);
  scene.materials[0].textures[TEXTURE_SLOT_BASE_COLOR].uv_from_vertex_uv = glm::mat3x2(1, 0, 0, 1, 0, 0);
  EXPECT_DOUBLE_EQ(terms_of(scene).base.x, 0.0);
}

TEST(SurfaceTerms, UnlitHasOnlyItsBase) {
  Material material;
  material.unlit = true;
  material.base_color = {0.5f, 0.25f, 1.0f, 1.0f};
  material.emission = glm::vec3(2.0f);
  material.transmission = glm::vec3(1.0f);
  const SurfaceTerms terms = terms_of(scene_of(material));
  expect_near(terms.base, {0.5, 0.25, 1.0});
  EXPECT_EQ(terms.emission, glm::dvec3(0.0));
  EXPECT_EQ(terms.transmission, glm::dvec3(0.0));
}

}  // namespace
}  // namespace vernier::reference
