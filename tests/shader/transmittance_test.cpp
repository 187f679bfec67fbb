#include <gtest/gtest.h>

#include <cmath>

#include "shader/shader.h"

namespace vernier::shader {
namespace {

/// Glass of a tint, in the plane z = const whose front looks along +Z. Blinn without Fresnel unless told otherwise.
HitSurface glass(const vec3& tint, std::uint32_t flags = WORKFLOW_BLINN, float alpha = 1.0f) {
  HitSurface surface{};
  surface.point.e1 = vec3(2, 0, 0);
  surface.point.e2 = vec3(0, 3, 0);
  surface.material.transmission = tint;
  surface.material.ior = 1.5f;
  surface.material.absorption = vec3(1, 2, 4);
  surface.material.flags = flags;
  surface.terms.transmission = tint;
  surface.terms.boundary_normal = 0.04f;  // of that index
  surface.terms.boundary_grazing = 1.0f;
  surface.alpha = alpha;
  return surface;
}

HitSurface wall(float alpha) {
  return glass(vec3(0), WORKFLOW_BLINN, alpha);
}

/// A shadow ray of value 1 along `direction`.
LightVisit visit_along(const vec3& direction) {
  LightVisit visit = no_visit();
  visit.ray = Ray(vec3(0, 0, 5), direction);
  visit.value = vec3(1);
  return visit;
}

Hit hit_at(float t, uint triangle) {
  return Hit(t, triangle, 0u, INSTANCE_WORLD);
}

TEST(Transmittance, a_wall_lets_through_what_its_opacity_leaves) {
  EXPECT_EQ(surface_transmittance(wall(1.0f), 1.0f), vec3(0));
  EXPECT_EQ(surface_transmittance(wall(0.25f), 1.0f), vec3(0.75f));
  EXPECT_EQ(surface_transmittance(wall(0.0f), 0.5f), vec3(1));
}

TEST(Transmittance, tinted_glass_without_fresnel) {
  const vec3 tint(0.5f, 0.25f, 1);
  for (const float cosine : {0.0f, 0.5f, 1.0f}) EXPECT_EQ(surface_transmittance(glass(tint), cosine), tint);
  EXPECT_EQ(surface_transmittance(glass(tint, WORKFLOW_BLINN, 0.5f), 1.0f), vec3(0.75f, 0.625f, 1));
  EXPECT_EQ(surface_transmittance(glass(tint, WORKFLOW_BLINN, 0.0f), 1.0f), vec3(1));
}

TEST(Transmittance, glass_reflects_a_part_by_fresnel) {
  for (const std::uint32_t flags : {WORKFLOW_METALLIC_ROUGHNESS, WORKFLOW_BLINN | MATERIAL_FRESNEL_REFLECTION}) {
    const HitSurface clear = glass(vec3(1, 0.5f, 0.25f), flags);
    // ior 1.5 straight on: R = (0.5 / 2.5)^2 = 0.04.
    const vec3 straight = surface_transmittance(clear, 1.0f);
    for (int i = 0; i < 3; ++i) EXPECT_FLOAT_EQ(straight[i], 0.96f * vec3(1, 0.5f, 0.25f)[i]);
    EXPECT_EQ(surface_transmittance(clear, 0.0f), vec3(0)) << "grazing: all is reflected";
    float before = 0.0f;
    for (const float cosine : {0.05f, 0.2f, 0.5f, 0.9f}) {
      const float through = surface_transmittance(clear, cosine).x;
      EXPECT_GT(through, before) << cosine;
      before = through;
    }
  }
  // At Brewster's angle, tan = ior, only the field across the plane is reflected: R = ((n^2 - 1) / (n^2 + 1))^2 / 2.
  const float brewster = 1.0f / std::sqrt(1.0f + 1.5f * 1.5f), across = (2.25f - 1) / (2.25f + 1);
  EXPECT_NEAR(surface_transmittance(glass(vec3(1), WORKFLOW_METALLIC_ROUGHNESS), brewster).x,
              1.0f - across * across / 2.0f, 4 * 0x1p-24f);  // a few roundings of numbers up to 1
}

TEST(Transmittance, index_1_is_not_there) {
  HitSurface air = glass(vec3(1), WORKFLOW_METALLIC_ROUGHNESS);
  air.material.ior = 1.0f;
  air.terms.boundary_normal = 0.0f;
  for (const float cosine : {0.25f, 0.5f, 1.0f}) EXPECT_EQ(surface_transmittance(air, cosine), vec3(1));
}

TEST(Transmittance, the_ray_goes_on_behind_the_hit) {
  LightVisit visit = visit_along(vec3(0, 0, -2));
  visit.value = vec3(0.5f, 1, 2);
  pass_surface(visit, hit_at(0.25f, 9u), glass(vec3(0.5f, 0.25f, 1)));
  EXPECT_EQ(visit.value, vec3(0.25f, 0.25f, 2));
  EXPECT_EQ(visit.t_min, 0.25f);
  EXPECT_EQ(visit.after_triangle, 9u);
  pass_surface(visit, hit_at(0.5f, 3u), wall(1.0f));
  EXPECT_EQ(visit.value, vec3(0));
}

TEST(Transmittance, either_side_reflects_alike) {
  const HitSurface clear = glass(vec3(1), WORKFLOW_METALLIC_ROUGHNESS);
  for (const vec3& direction : {vec3(0, 0, 1), vec3(0.6f, 0, 0.8f), vec3(3, 0, 4)}) {
    LightVisit down = visit_along(-direction), up = visit_along(direction);
    pass_surface(down, hit_at(1, 0u), clear);
    pass_surface(up, hit_at(1, 0u), clear);
    EXPECT_EQ(down.value, up.value);
    // The cosine is that of the angle, whatever the lengths of ray and edges.
    const float cosine = direction.z / std::sqrt(direction.x * direction.x + direction.z * direction.z);
    EXPECT_FLOAT_EQ(down.value.x, fresnel_dielectric(cosine, 1.5f).transmitted);
  }
}

TEST(Transmittance, absorption_counts_the_way_inside) {
  // t counts in directions 2 long: in at t = 1, out at t = 1.5: one unit of glass.
  LightVisit visit = visit_along(vec3(0, 0, -2));
  pass_surface(visit, hit_at(1.0f, 0u), glass(vec3(1)));
  visit.ray.direction = vec3(0, 0, -2);
  HitSurface exit = glass(vec3(1));
  exit.point.e1 = -exit.point.e1;  // its front looks along -Z
  pass_surface(visit, hit_at(1.5f, 1u), exit);
  EXPECT_EQ(visit.optical_depth, vec3(1, 2, 4));
  const vec3 light = arriving_light(visit);
  for (int i = 0; i < 3; ++i) EXPECT_FLOAT_EQ(light[i], std::exp(-vec3(1, 2, 4)[i]));
  EFFECTS = ~EFFECT_ABSORPTION;
  EXPECT_EQ(arriving_light(visit), vec3(1));
  EFFECTS = 0xffffffffu;
}

TEST(Transmittance, from_inside_the_way_to_the_exit_counts) {
  LightVisit visit = visit_along(vec3(0, 0, 0.5f));
  pass_surface(visit, hit_at(4.0f, 0u), glass(vec3(1)));
  EXPECT_EQ(visit.optical_depth, vec3(2, 4, 8));
}

TEST(Transmittance, a_light_inside_the_glass_loses_nothing) {
  // An entry alone leaves a sum below 0, which counts as 0.
  LightVisit visit = visit_along(vec3(0, 0, -1));
  pass_surface(visit, hit_at(2.0f, 0u), glass(vec3(0.5f)));
  EXPECT_EQ(visit.optical_depth, vec3(-2, -4, -8));
  EXPECT_EQ(arriving_light(visit), vec3(0.5f));
}

TEST(Transmittance, only_bodies_of_glass_absorb) {
  for (const HitSurface& surface :
       {wall(0.5f), glass(vec3(1), WORKFLOW_BLINN | MATERIAL_THIN_WALLED), glass(vec3(1), WORKFLOW_BLINN, 0.0f)}) {
    LightVisit visit = visit_along(vec3(0, 0, 1));
    pass_surface(visit, hit_at(2.0f, 0u), surface);
    EXPECT_EQ(visit.optical_depth, vec3(0));
  }
  LightVisit visit = visit_along(vec3(0, 0, 1));
  EFFECTS = ~EFFECT_ABSORPTION;
  pass_surface(visit, hit_at(2.0f, 0u), glass(vec3(1)));
  EFFECTS = 0xffffffffu;
  EXPECT_EQ(visit.optical_depth, vec3(0));
}

}  // namespace
}  // namespace vernier::shader
