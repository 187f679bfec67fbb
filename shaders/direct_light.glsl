// Light that reaches a surface straight from the scene's lights. shaders/README.md, Image formation 5.4.
#ifndef VERNIER_DIRECT_LIGHT_GLSL
#define VERNIER_DIRECT_LIGHT_GLSL

#include "blinn.glsl"
#include "light.glsl"
#include "loop_limit.glsl"
#include "path.glsl"
#include "shading_terms.glsl"
#include "spawn_ray.glsl"

// What the light adds without its shadow: diffuse and highlight.
vec3 reflected_light(IN(SurfacePoint) surface, IN(ShadingTerms) terms, IN(vec3) to_viewer, IN(LightSample) light, IN(float) cosine) {
  vec3 reflected = terms.diffuse * (cosine / PI);
  if (effect_on(EFFECT_SPECULAR)) {
    note_run(EFFECT_SPECULAR);
    float highlight = blinn_highlight(surface.normal, light.direction, to_viewer, terms.exponent);
    reflected += terms.specular * (highlight * (terms.cosine ? cosine : 1.0f));
  }
  return reflected * light.irradiance;
}

// Where the way to a light in `direction` begins. A triangle that faces away from it may be lit all the same, where its
// vertex normals round it off: by way of the rounded surface, from which the triangle itself may stand in the way.
vec3 light_ray_origin(IN(SurfacePoint) surface, IN(vec3) direction) {
  if (dot_product(surface.geometric_normal, direction) > 0.0f) return spawn_origin(surface, direction);
  return spawn_origin(surface, surface.geometric_normal) + surface.rise;
}

// Asks the lights from visit.next_light on, up to the first whose light has to be proven by a shadow ray: the ray is put
// into `visit`, and visit.value is what the light adds by the surface alone; true. Lights that need no such ray are added
// to `sum`. False: no light is left, or a loop limit cut the search off and visit.next_light says where.
bool ask_lights(IN(SurfacePoint) surface, IN(ShadingTerms) terms, IN(vec3) to_viewer, INOUT(LightVisit) visit, INOUT(vec3) sum) {
  uint light_count = steering_constants().light_count;
  bool found = false;
  vec3 value = vec3(0.0f);
  vec3 direction = vec3(0.0f);
  vec3 offset = vec3(0.0f);
  bool directional = false;
  bool rises = dot_product(surface.geometric_normal, surface.rise) > 0.0f && !mutated(MUTATION_FACET_TERMINATOR);
  // One variable decides, and lights_are_done() works its answer out by itself: a compiler that sees the loop end on a
  // comparison takes the outcome for granted behind it, where llvmpipe may have left the loop without.
  bool looking = visit.next_light < light_count;
  uint round = 0u;
  bool done = false;
  if (looking) {
    for (;;) {
      if (!TEST_LAST && done) break;
      LightSample light = sample_light(fetch_light(visit.next_light), surface.position);
      visit.next_light++;
      float cosine = dot_product(surface.normal, light.direction);
      bool faces = rises || dot_product(surface.geometric_normal, light.direction) > 0.0f;
      bool lit = faces && cosine > 0.0f && max3(light.irradiance) > 0.0f;
      vec3 reflected = lit ? reflected_light(surface, terms, to_viewer, light, cosine) : vec3(0.0f);
      if (!effect_on(EFFECT_SHADOWS)) {
        sum += reflected;
      } else if (max3(reflected) > 0.0f) {
        found = true;
        note_run(EFFECT_SHADOWS);
        value = reflected;
        direction = light.direction;
        offset = light.offset;
        directional = light.directional;
      }
      looking = !found && visit.next_light < light_count;
      round++;
      done = !looking || round >= LOOP_ROUND_LIMIT;
      if (TEST_LAST && done) break;
    }
  }
  // Of the ray nothing matters where none was found.
  vec3 origin = light_ray_origin(surface, direction);
  // Towards a point light the ray ends at t = 1, at the light; the offset of its start is taken into account.
  visit.ray = Ray(origin, directional ? direction : offset + (surface.position - origin));
  visit.t_min = 0.0f;
  visit.after_triangle = NONE;
  visit.t_max = directional ? LARGEST_FLOAT : 1.0f;
  visit.value = value;
  visit.optical_depth = vec3(0.0f);
  return found;
}

// Whether all lights have been asked.
bool lights_are_done(IN(LightVisit) visit) { return visit.next_light >= steering_constants().light_count; }

#endif
