#include <gtest/gtest.h>

#include <bit>
#include <limits>
#include <numbers>

#include "shader/random_values.h"
#include "shader/shader.h"

namespace vernier::shader {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr vec3 kUp(0, 0, 1);

/// A place on the plane z = 0 seen from above, whose rounding nobody knows to a micrometre; a quarter of the way from
/// corner 0 of a triangle to corners (1, 0, 0) and (0, 1, 0) from there.
SurfacePoint floor_at(const vec3& place, const vec3& normal = kUp) {
  return SurfacePoint{place,   vec3(1e-6f), kUp,   normal,        true,          0u,  0.0f,
                      vec3(0), 0.25f,       0.25f, vec3(1, 0, 0), vec3(0, 1, 0), 1.0f};
}

ShadingTerms matte(const vec3& diffuse) {
  ShadingTerms terms{};
  terms.diffuse = diffuse;
  return terms;
}

DeviceLight point_light(const vec3& position, float intensity) {
  DeviceLight light{};
  light.kind = LIGHT_POINT;
  light.position = position;
  light.intensity = vec3(intensity);
  light.range = std::numeric_limits<float>::infinity();
  return light;
}

DeviceLight directional_light(const vec3& direction, float lux) {
  DeviceLight light{};
  light.kind = LIGHT_DIRECTIONAL;
  light.direction = direction;
  light.intensity = vec3(lux);
  return light;
}

Memory lit_by(const std::vector<DeviceLight>& lights) {
  Memory scene;
  for (const DeviceLight& light : lights) {
    const auto texels = std::bit_cast<std::array<uvec4, LIGHT_TEXELS>>(light);
    scene.lights.insert(scene.lights.end(), texels.begin(), texels.end());
  }
  scene.dispatch.steering.light_count = static_cast<uint>(lights.size());
  return scene;
}

/// Light of 2 lux out of `direction` on a floor of `terms`, seen from there as well.
vec3 reflected(const ShadingTerms& terms, const vec3& direction, const vec3& to_viewer) {
  const LightSample light(direction, vec3(2), direction, true);
  return reflected_light(floor_at(vec3(0)), terms, to_viewer, light, direction.z);
}

TEST(DirectLight, a_matte_surface_reflects_by_the_cosine) {
  // Powers of two: only the division by pi and the products with it round.
  const vec3 up = reflected(matte(vec3(0.5f, 0.25f, 1)), kUp, kUp);
  for (int i = 0; i < 3; ++i) EXPECT_FLOAT_EQ(up[i], vec3(1, 0.5f, 2)[i] / kPi);
  const vec3 slanted = reflected(matte(vec3(0.5f)), vec3(0.6f, 0, 0.8f), kUp);
  EXPECT_FLOAT_EQ(slanted.x, 0.8f / kPi);
  EXPECT_EQ(slanted, reflected(matte(vec3(0.5f)), vec3(0.6f, 0, 0.8f), vec3(0.8f, 0, 0.6f))) << "from everywhere alike";
}

TEST(DirectLight, the_highlight_is_whole_in_the_mirror_direction) {
  ShadingTerms terms = matte(vec3(0));
  terms.specular = vec3(0.25f, 0.5f, 1);
  terms.exponent = 64.0f;
  const vec3 light(0.6f, 0, 0.8f), mirrored(-0.6f, 0, 0.8f);
  terms.cosine = false;
  const vec3 plain = reflected(terms, light, mirrored);
  terms.cosine = true;
  const vec3 weighed = reflected(terms, light, mirrored);
  for (int i = 0; i < 3; ++i) {
    EXPECT_FLOAT_EQ(plain[i], 2.0f * terms.specular[i]);
    EXPECT_FLOAT_EQ(weighed[i], 2.0f * 0.8f * terms.specular[i]);
  }
  // Light straight from above, viewer at 60 degrees: H at 30 degrees, cos^2 30 = 3/4.
  terms.exponent = 2.0f;
  EXPECT_FLOAT_EQ(reflected(terms, kUp, vec3(std::sqrt(0.75f), 0, 0.5f)).z, 2.0f * 0.75f);
}

TEST(DirectLight, diffuse_and_highlight_add_up) {
  ShadingTerms both = matte(vec3(0.5f));
  both.specular = vec3(0.25f);
  both.exponent = 10.0f;
  ShadingTerms shiny = both;
  shiny.diffuse = vec3(0);
  const vec3 light(0.6f, 0, 0.8f), viewer(0, 0.6f, 0.8f);
  EXPECT_FLOAT_EQ(reflected(both, light, viewer).x,
                  reflected(matte(vec3(0.5f)), light, viewer).x + reflected(shiny, light, viewer).x);
  EFFECTS = ~EFFECT_SPECULAR;
  EXPECT_EQ(reflected(both, light, viewer), reflected(matte(vec3(0.5f)), light, viewer));
  EFFECTS = 0xffffffffu;
}

TEST(DirectLight, light_and_viewer_may_change_places_for_the_highlight) {
  ShadingTerms terms = matte(vec3(0));
  terms.specular = vec3(1);
  terms.exponent = 20.0f;
  terms.cosine = false;
  RandomValues random(3);
  for (int i = 0; i < 1000; ++i) {
    vec3 a = random.direction(), b = random.direction();
    a.z = std::abs(a.z), b.z = std::abs(b.z);
    ASSERT_EQ(reflected(terms, a, b), reflected(terms, b, a));  // L + V is the same sum
  }
}

/// The answer to asking all lights of bound memory from `next_light` on.
struct Asked {
  LightVisit visit;
  vec3 sum;
  bool found;
  uint phase;
};

Asked ask(const SurfacePoint& surface, const ShadingTerms& terms, uint next_light = 0u, bool rise_is_free = false) {
  Asked asked{no_visit(), vec3(0), false, PHASE_LIGHT};
  asked.visit.next_light = next_light;
  asked.phase = ask_lights(surface, terms, kUp, rise_is_free, asked.visit, asked.sum);
  asked.found = asked.phase != PHASE_LIGHT;
  return asked;
}

TEST(DirectLight, a_triangle_that_faces_away_is_asked_for_from_where_it_is_rounded_off_to) {
  const vec3 towards = glm::normalize(vec3(0.5f, 0, -0.125f));
  Memory scene = lit_by({directional_light(-towards, 2.0f)});
  const BoundMemory bound(scene);
  SurfacePoint surface = floor_at(vec3(1, 2, 0), glm::normalize(vec3(1, 0, 1)));
  EXPECT_FALSE(ask(surface, matte(vec3(1))).found) << "nothing rounds it off";
  surface.rise = vec3(0.5f, 0, -0.25f);
  EXPECT_FALSE(ask(surface, matte(vec3(1))).found) << "that would be below it";
  surface.rise = vec3(0, 0, 0.25f);
  const Asked above = ask(surface, matte(vec3(1)));
  ASSERT_EQ(above.phase, PHASE_RISE);
  EXPECT_EQ(above.visit.ray.origin, vec3(1, 2, 1e-6f));
  EXPECT_FLOAT_EQ(above.visit.ray.direction.z, 0.25f);
  EXPECT_EQ(above.visit.t_max, 1.0f);
  const Asked asked = ask(surface, matte(vec3(1)), above.visit.next_light, true);
  ASSERT_EQ(asked.phase, PHASE_SHADOW);
  EXPECT_EQ(asked.visit.next_light, 1u);
  EXPECT_FLOAT_EQ(asked.visit.ray.origin.z, 0.25f + 1e-6f) << "above the floor, though the light is below";
  EXPECT_EQ(asked.visit.ray.direction, towards);
  EXPECT_EQ(asked.visit.t_max, LARGEST_FLOAT);
  surface.rise = vec3(0, 0, 0.0625f);
  EXPECT_FALSE(ask(surface, matte(vec3(1))).found) << "1/4 aside it comes down through the triangle";
  surface.rise = vec3(0, 0, 0.25f);
  surface.normal = glm::normalize(vec3(0, 1, 1));
  EXPECT_FALSE(ask(surface, matte(vec3(1))).found) << "the rounded surface faces away, too";
}

TEST(DirectLight, a_shadow_ray_to_a_directional_light_has_no_end) {
  Memory scene = lit_by({directional_light(vec3(0, 0, -1), 2.0f)});
  const BoundMemory bound(scene);
  const Asked asked = ask(floor_at(vec3(1, 2, 0)), matte(vec3(0.5f)));
  ASSERT_TRUE(asked.found);
  EXPECT_EQ(asked.visit.ray.direction, kUp);
  EXPECT_EQ(asked.visit.ray.origin, vec3(1, 2, 1e-6f)) << "off the floor by the error of the place";
  EXPECT_EQ(asked.visit.t_min, 0.0f);
  EXPECT_EQ(asked.visit.t_max, LARGEST_FLOAT);
  EXPECT_EQ(asked.visit.after_triangle, NONE);
  EXPECT_EQ(asked.visit.optical_depth, vec3(0));
  EXPECT_FLOAT_EQ(asked.visit.value.x, 1.0f / kPi);
  EXPECT_EQ(asked.sum, vec3(0));
  EXPECT_EQ(asked.visit.next_light, 1u);
  EXPECT_TRUE(lights_are_done(asked.visit));
}

TEST(DirectLight, a_shadow_ray_to_a_point_light_ends_in_it) {
  RandomValues random(4);
  for (int i = 0; i < 1000; ++i) {
    const vec3 place = vec3(random.in(-1, 1), random.in(-1, 1), 0), light = random.in_cube() + vec3(0, 0, 1.5f);
    Memory scene = lit_by({point_light(light, 1.0f)});
    const BoundMemory bound(scene);
    const Asked asked = ask(floor_at(place), matte(vec3(1)));
    ASSERT_TRUE(asked.found);
    EXPECT_EQ(asked.visit.t_max, 1.0f);
    const glm::dvec3 end = glm::dvec3(asked.visit.ray.origin) + glm::dvec3(asked.visit.ray.direction);
    // Origin, offset to the light and their sum are rounded, all below 4.
    for (int axis = 0; axis < 3; ++axis) ASSERT_NEAR(end[axis], light[axis], 3 * 4 * 0x1p-24);
    ASSERT_GT(asked.visit.ray.origin.z, 0.0f);
  }
}

TEST(DirectLight, lights_that_add_nothing_are_passed_over) {
  const vec3 below(0, 0, -2);
  DeviceLight out_of_range = point_light(vec3(0, 0, 2), 1.0f);
  out_of_range.range = 1.0f;
  Memory scene = lit_by({point_light(below, 1.0f), out_of_range, point_light(vec3(0), 1.0f),
                         directional_light(vec3(0, 0, 1), 1.0f), directional_light(vec3(1, 0, 0), 1.0f)});
  const BoundMemory bound(scene);
  const Asked asked = ask(floor_at(vec3(0)), matte(vec3(1)));
  EXPECT_FALSE(asked.found);
  EXPECT_EQ(asked.visit.next_light, 5u);
  EXPECT_EQ(asked.sum, vec3(0));
  Memory bright = lit_by({point_light(vec3(0, 0, 2), 1.0f)});
  const BoundMemory other(bright);
  EXPECT_FALSE(ask(floor_at(vec3(0)), matte(vec3(0))).found) << "a black surface";
  EXPECT_TRUE(ask(floor_at(vec3(0)), matte(vec3(0, 0, 1))).found);
}

TEST(DirectLight, both_normals_have_to_see_the_light) {
  const vec3 tilted(0.8f, 0, 0.6f);
  // The first light lies below the plane yet above the shading normal's horizon, the second the other way round.
  Memory scene = lit_by({directional_light(vec3(-0.8f, 0, 0.6f), 1.0f), directional_light(vec3(0.8f, 0, -0.6f), 1.0f)});
  const BoundMemory bound(scene);
  EXPECT_FALSE(ask(floor_at(vec3(0), tilted), matte(vec3(1))).found);
  EXPECT_TRUE(ask(floor_at(vec3(0)), matte(vec3(1))).found) << "the second one lights an even floor";
}

TEST(DirectLight, one_light_after_the_other) {
  Memory scene = lit_by({directional_light(vec3(0, 0, 1), 1.0f), directional_light(vec3(0, 0, -1), 2.0f),
                         point_light(vec3(0, 0, -1), 4.0f), point_light(vec3(0, 0, 2), 8.0f)});
  const BoundMemory bound(scene);
  const Asked first = ask(floor_at(vec3(0)), matte(vec3(1)));
  ASSERT_TRUE(first.found);
  EXPECT_EQ(first.visit.next_light, 2u);
  EXPECT_FALSE(lights_are_done(first.visit));
  const Asked second = ask(floor_at(vec3(0)), matte(vec3(1)), first.visit.next_light);
  ASSERT_TRUE(second.found);
  EXPECT_EQ(second.visit.next_light, 4u);
  EXPECT_TRUE(lights_are_done(second.visit));
  EXPECT_FLOAT_EQ(first.visit.value.x, 2.0f / kPi);
  EXPECT_FLOAT_EQ(second.visit.value.x, 2.0f / kPi);  // 8 cd at 2 m
  EXPECT_FALSE(ask(floor_at(vec3(0)), matte(vec3(1)), 4u).found);
}

TEST(DirectLight, without_shadows_all_lights_add_at_once) {
  Memory scene = lit_by({directional_light(vec3(0, 0, 1), 1.0f), directional_light(vec3(0, 0, -1), 2.0f),
                         point_light(vec3(0, 0, 2), 8.0f)});
  const BoundMemory bound(scene);
  EFFECTS = ~EFFECT_SHADOWS;
  const Asked asked = ask(floor_at(vec3(0)), matte(vec3(1)));
  EFFECTS = 0xffffffffu;
  EXPECT_FALSE(asked.found);
  EXPECT_TRUE(lights_are_done(asked.visit));
  EXPECT_FLOAT_EQ(asked.sum.x, 4.0f / kPi);
}

TEST(DirectLight, no_light_at_all) {
  Memory scene = lit_by({});
  const BoundMemory bound(scene);
  const Asked asked = ask(floor_at(vec3(0)), matte(vec3(1)));
  EXPECT_FALSE(asked.found);
  EXPECT_TRUE(lights_are_done(asked.visit));
}

}  // namespace
}  // namespace vernier::shader
