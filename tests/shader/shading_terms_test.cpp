#include <gtest/gtest.h>

#include <numbers>

#include "render/pack_materials.h"
#include "shader/shader.h"

namespace vernier::shader {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

void expect_near(const vec3& value, const vec3& expected, float tolerance = 1e-6f) {
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(value[i], expected[i], tolerance * std::max(1.0f, std::abs(expected[i]))) << i;
}

ShadingTerms terms_of(const Material& material, const SlotTexels& texels = no_slot_texels(), vec3 color = vec3(1)) {
  return shading_terms(device_material(material, 1.0), texels, color);
}

/// Exponent of image formation 4.
float exponent(float roughness) {
  const float alpha = std::max(roughness * roughness, 0x1p-5f);
  return 2.0f / (alpha * alpha) - 2.0f;
}

TEST(ShadingTerms, a_rough_dielectric) {
  Material material;
  material.base_color = glm::vec4(0.8f, 0.4f, 0.2f, 1);
  material.roughness = 1.0f;
  const ShadingTerms terms = terms_of(material);
  // ior 1.5: F0 = 0.04; e = 0; nothing is mirrored sharply.
  expect_near(terms.diffuse, vec3(0.8f, 0.4f, 0.2f) * 0.96f);
  expect_near(terms.specular, vec3(0.04f * 2 / (8 * kPi)));
  EXPECT_EQ(terms.exponent, 0.0f);
  EXPECT_TRUE(terms.cosine);
  expect_near(terms.ambient, vec3(0.8f, 0.4f, 0.2f) * 0.96f + 0.04f);
  EXPECT_EQ(terms.mirror, vec3(0));
  EXPECT_EQ(terms.mirror_grazing, vec3(0));
  EXPECT_EQ(terms.transmission, vec3(0));
  expect_near(terms.base, vec3(0.8f, 0.4f, 0.2f));
}

TEST(ShadingTerms, half_rough_metal) {
  Material material;
  material.base_color = glm::vec4(0.9f, 0.6f, 0.3f, 1);
  material.metallic = 1.0f;
  material.roughness = 0.5f;
  const ShadingTerms terms = terms_of(material);
  const vec3 f0(0.9f, 0.6f, 0.3f);
  EXPECT_EQ(terms.diffuse, vec3(0));
  expect_near(terms.specular, f0 * (exponent(0.5f) + 2) / (8 * kPi));
  EXPECT_FLOAT_EQ(terms.exponent, 30.0f);
  expect_near(terms.mirror, f0 * 0.25f);
  expect_near(terms.mirror_grazing, vec3(0.25f));
  expect_near(terms.ambient, f0 * 0.75f);
}

TEST(ShadingTerms, textures_of_metallic_roughness_by_channel) {
  Material material;
  material.base_color = glm::vec4(0.5f);
  material.metallic = 0.8f;
  material.roughness = 0.9f;
  material.specular = vec3(0.5f, 1, 2);
  material.specular_strength = 0.7f;
  material.transmission = vec3(0.6f);
  material.emission = vec3(3, 4, 5);
  material.occlusion_strength = 0.5f;
  SlotTexels texels = no_slot_texels();
  texels.base_color = vec4(0.2f, 0.4f, 0.8f, 0.1f);
  texels.surface = vec4(9, 0.5f, 0.25f, 9);
  texels.specular = vec4(9, 9, 9, 0.5f);
  texels.specular_color = vec4(1, 0.5f, 0.25f, 9);
  texels.transmission = vec4(0.5f, 9, 9, 9);
  texels.emission = vec4(1, 0.5f, 0, 9);
  texels.occlusion = vec4(0.4f, 9, 9, 9);
  const ShadingTerms terms = terms_of(material, texels, vec3(1, 0.5f, 1));
  const vec3 base(0.1f, 0.1f, 0.4f);
  const float m = 0.2f, r = 0.45f, st = 0.35f, tau = 0.3f, clear = tau * (1 - m);
  const float gloss = 1 - (1 - 0.55f * 0.55f) * (1 - clear);
  const vec3 f = vec3(0.02f, 0.02f, 0.02f) * st;
  const vec3 f0 = f + (base - f) * m;
  const vec3 diffuse = base * ((1 - m) * (1 - tau) * (1 - f.z));
  expect_near(terms.diffuse, diffuse);
  EXPECT_NEAR(terms.exponent, exponent(r), 1e-4f * exponent(r));
  expect_near(terms.mirror, f0 * gloss);
  expect_near(terms.mirror_grazing, vec3((st + (1 - st) * m) * gloss));
  expect_near(terms.ambient, (diffuse + f0 * (1 - gloss)) * 0.7f);
  expect_near(terms.transmission, base * clear);
  EXPECT_FLOAT_EQ(terms.boundary_normal, f.z);
  EXPECT_FLOAT_EQ(terms.boundary_grazing, st);
  expect_near(terms.emission, vec3(3, 2, 0));
}

TEST(ShadingTerms, a_half_metal_is_half_as_diffuse) {
  Material material;
  material.base_color = glm::vec4(1);
  material.metallic = 0.5f;
  const ShadingTerms terms = terms_of(material, no_slot_texels(), vec3(4, 1, 1));  // brighter than white
  expect_near(terms.diffuse, vec3(4, 1, 1) * (0.5f * 0.96f));
  EXPECT_GT(terms.specular.x, 0.0f);
}

TEST(ShadingTerms, specular_glossiness) {
  Material material;
  material.workflow = Workflow::specular_glossiness;
  material.base_color = glm::vec4(0.5f, 0.4f, 0.3f, 1);
  material.specular = vec3(0.2f, 0.4f, 3.0f);
  material.roughness = 0.4f;  // glossiness 0.6
  SlotTexels texels = no_slot_texels();
  texels.surface = vec4(0.5f, 0.5f, 0.1f, 0.5f);
  const ShadingTerms terms = terms_of(material, texels);
  const vec3 f0(0.1f, 0.2f, 0.3f);
  expect_near(terms.diffuse, vec3(0.5f, 0.4f, 0.3f) * 0.7f);
  expect_near(terms.mirror, f0 * 0.09f);
  expect_near(terms.mirror_grazing, vec3(0.09f));
  EXPECT_NEAR(terms.exponent, exponent(0.7f), 1e-4f * exponent(0.7f));
  material.specular = vec3(0);
  EXPECT_EQ(terms_of(material).mirror_grazing, vec3(0));
}

TEST(ShadingTerms, mtl_terms_are_those_of_the_file) {
  Material material;
  material.workflow = Workflow::blinn;
  material.base_color = glm::vec4(0.5f, 0.4f, 0.3f, 1);
  material.specular = vec3(0.6f, 0.3f, 0.9f);
  material.exponent = 80.0f;
  material.ambient = vec3(0.1f, 0.2f, 0.3f);
  material.reflection = vec3(0.2f, 0.4f, 0.6f);
  material.transmission = vec3(0.7f, 0.8f, 0.9f);
  SlotTexels texels = no_slot_texels();
  texels.surface = vec4(0.5f, 1, 0.5f, 9);
  texels.specular = vec4(0.5f, 9, 9, 9);
  texels.specular_color = vec4(0.5f, 0.5f, 1, 9);
  ShadingTerms terms = terms_of(material, texels);
  expect_near(terms.diffuse, vec3(0.5f, 0.4f, 0.3f));
  expect_near(terms.specular, vec3(0.3f, 0.3f, 0.45f) / kPi);
  EXPECT_FLOAT_EQ(terms.exponent, 40.0f);
  EXPECT_FALSE(terms.cosine);
  expect_near(terms.ambient, vec3(0.05f, 0.1f, 0.3f));
  expect_near(terms.mirror, vec3(0.1f, 0.4f, 0.3f));
  expect_near(terms.mirror_grazing, terms.mirror);
  expect_near(terms.transmission, vec3(0.7f, 0.8f, 0.9f));
  expect_near(terms_of(material, texels, vec3(0.5f, 1, 0)).ambient, vec3(0.025f, 0.1f, 0));
  material.fresnel_reflection = true;
  material.ior = 1.5f;
  terms = terms_of(material, texels);
  expect_near(terms.mirror, vec3(0.04f));  // Fresnel's, since it is glass
  EXPECT_EQ(terms.mirror_grazing, vec3(1));
  EXPECT_FLOAT_EQ(terms.boundary_normal, 0.04f);
  EXPECT_EQ(terms.boundary_grazing, 1.0f);
  material.transmission = vec3(0);
  expect_near(terms_of(material, texels).mirror, vec3(0.1f, 0.4f, 0.3f));
}

TEST(ShadingTerms, the_sharpest_highlight_has_an_end) {
  EXPECT_FLOAT_EQ(exponent_of_roughness(0.0f), exponent(0.0f));
  EXPECT_LT(exponent_of_roughness(0.0f), 1e6f);
  EXPECT_EQ(exponent_of_roughness(1.0f), 0.0f);
}

}  // namespace
}  // namespace vernier::shader
