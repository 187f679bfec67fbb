#include "effects/fixed_effects.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "one_triangle.h"

namespace vernier {
namespace {

EffectReason fixed_of(const Scene& scene, const std::string& name) {
  const std::vector<EffectReason> fixed = detect_effects(scene, Camera{}, 8).fixed;
  const auto found = std::ranges::find(fixed, name, &EffectReason::name);
  return found == fixed.end() ? EffectReason{} : *found;
}

TEST(FixedEffects, light_attenuation_is_that_of_a_light_with_a_place) {
  Scene scene = white_triangle();
  scene.lights = {light_of(LightKind::directional)};
  EXPECT_FALSE(fixed_of(scene, "light_attenuation").on);
  scene.lights = {light_of(LightKind::spot)};
  EXPECT_TRUE(fixed_of(scene, "light_attenuation").on);
  EXPECT_EQ(fixed_of(scene, "light_attenuation").reason,
            "light 0 (lamp) falls on material 0 (paint), weaker with the distance");
}

TEST(FixedEffects, double_sided_is_what_a_visible_material_says) {
  Scene scene = white_triangle();
  EXPECT_FALSE(fixed_of(scene, "double_sided").on);
  scene.materials.push_back(scene.materials[0]);
  scene.materials[1].double_sided = true;
  EXPECT_FALSE(fixed_of(scene, "double_sided").on) << "no triangle uses it";
  scene.materials[0].double_sided = true;
  EXPECT_TRUE(fixed_of(scene, "double_sided").on);
}

TEST(FixedEffects, texture_transform_is_that_of_a_texture_that_counts) {
  Scene scene = white_triangle();
  add_texture(scene, TEXTURE_SLOT_BASE_COLOR);
  EXPECT_FALSE(fixed_of(scene, "texture_transform").on);
  scene.materials[0].textures[TEXTURE_SLOT_BASE_COLOR].uv_from_vertex_uv[0][0] = 2.0f;
  EXPECT_TRUE(fixed_of(scene, "texture_transform").on);
  scene.materials[0].base_color = glm::vec4(0, 0, 0, 1);
  EXPECT_FALSE(fixed_of(scene, "texture_transform").on);
}

}  // namespace
}  // namespace vernier
