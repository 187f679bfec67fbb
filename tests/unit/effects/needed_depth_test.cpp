#include "effects/needed_depth.h"

#include <gtest/gtest.h>

#include "effects/choose_effects.h"
#include "one_triangle.h"

namespace vernier {
namespace {

/// A surface of roughness 1/2: each reflection leaves at most a quarter.
Scene glossy_triangle() {
  Scene scene = white_triangle();
  scene.materials[0].specular_strength = 1.0f;
  scene.materials[0].roughness = 0.5f;
  return scene;
}

DepthNeed depth_of(const Scene& scene, double cutoff, int max_bounces = 8) {
  return detect_effects(scene, Camera{}, max_bounces, cutoff).depth;
}

TEST(NeededDepth, is_zero_where_nothing_is_reflected) {
  const DepthNeed depth = depth_of(white_triangle(), 0.001);
  EXPECT_EQ(depth.bounces, 0u);
  EXPECT_EQ(depth.allowed, 8u);
  EXPECT_EQ(depth.reason, "no ray is reflected or refracted");
}

TEST(NeededDepth, is_that_at_which_the_weight_falls_below_the_cutoff) {
  EXPECT_EQ(depth_of(glossy_triangle(), 0.26).bounces, 0u);
  EXPECT_EQ(depth_of(glossy_triangle(), 0.25).bounces, 1u) << "a ray of exactly that weight is traced";
  EXPECT_EQ(depth_of(glossy_triangle(), 0.01).bounces, 3u);
  EXPECT_EQ(depth_of(glossy_triangle(), 0.01, 2).bounces, 2u) << "no more than allowed";
  EXPECT_EQ(depth_of(glossy_triangle(), 0.0).bounces, 8u) << "without a cutoff";
}

TEST(NeededDepth, is_all_that_is_allowed_where_no_bound_is_known) {
  Scene polished = glossy_triangle();
  polished.materials[0].roughness = 0.0f;
  EXPECT_EQ(depth_of(polished, 0.01).bounces, 8u);
  Scene glass = glossy_triangle();
  glass.materials[0].transmission = glm::vec3(0.1f);
  EXPECT_EQ(depth_of(glass, 0.01).bounces, 8u);
  Scene textured = glossy_triangle();
  add_texture(textured, TEXTURE_SLOT_SURFACE);
  EXPECT_EQ(depth_of(textured, 0.01).bounces, 8u) << "a texel may polish it";
  Scene colored = glossy_triangle();
  colored.meshes[0].colors.assign(3, glm::vec4(2.0f));
  EXPECT_EQ(depth_of(colored, 0.01).bounces, 8u);
  Scene odd = glossy_triangle();
  odd.materials[0].roughness = -1.0f;
  EXPECT_EQ(depth_of(odd, 0.01).bounces, 8u);
}

TEST(NeededDepth, is_all_that_is_allowed_for_more_than_was_found) {
  const EffectSet detected = detect_effects(white_triangle(), Camera{}, 8, 0.01);
  EXPECT_EQ(choose_effects(detected, "all").depth.bounces, 8u);
  EXPECT_EQ(choose_effects(detected, "auto,reflection").depth.bounces, 8u);
  EXPECT_EQ(choose_effects(detected, "auto,-ambient").depth.bounces, 0u);
}

TEST(DetectReflection, is_off_where_the_cutoff_takes_every_ray) {
  Scene scene = glossy_triangle();
  EXPECT_TRUE((detect_effects(scene, Camera{}, 8, 0.25).bits & EFFECT_REFLECTION) != 0);
  const EffectSet weak = detect_effects(scene, Camera{}, 8, 0.26);
  EXPECT_FALSE((weak.bits & EFFECT_REFLECTION) != 0);
  EXPECT_EQ(reason_for(weak, EFFECT_REFLECTION), "material 0 (paint): mirrors; but always weaker than the cutoff");
}

TEST(DetectReflection, glass_of_the_index_around_it_has_no_boundary) {
  Scene scene = glossy_triangle();
  Material& glass = scene.materials[0];
  glass.transmission = glm::vec3(1.0f);
  glass.ior = 1.0f;
  const EffectSet effects = detect_effects(scene, Camera{}, 8);
  EXPECT_FALSE((effects.bits & EFFECT_REFLECTION) != 0);
  EXPECT_TRUE((effects.bits & EFFECT_REFRACTION) != 0);
  EXPECT_EQ(reason_for(effects, EFFECT_REFLECTION),
            "material 0 (paint): reflects at its interface; but its ior is that of what is around it");
  add_texture(scene, TEXTURE_SLOT_TRANSMISSION);
  EXPECT_TRUE(is_on(scene, EFFECT_REFLECTION))
      << "where a texel leaves no transmission it mirrors at grazing incidence";
}

TEST(DetectReflection, mtl_glass_of_the_index_around_it_mirrors_by_its_own_factor_alone) {
  Scene scene = one_triangle();
  Material& glass = scene.materials[0];
  glass.workflow = Workflow::blinn;
  glass.transmission = glm::vec3(1.0f);
  glass.fresnel_reflection = true;
  EXPECT_TRUE(is_on(scene, EFFECT_REFLECTION));
  glass.ior = 1.0f;
  EXPECT_FALSE(is_on(scene, EFFECT_REFLECTION));
  glass.fresnel_reflection = false;
  glass.reflection = glm::vec3(0.5f);
  EXPECT_TRUE(is_on(scene, EFFECT_REFLECTION));
}

}  // namespace
}  // namespace vernier
