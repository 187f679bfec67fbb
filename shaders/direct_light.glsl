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

// A triangle that faces away from a light may be lit all the same where its vertex normals round it off: from above it, if
// nothing lies in between. Whether the way from there to the light comes down through the triangle is told by the weights:
// a search would not find a triangle that its ray starts on, as far as it can tell.
bool crosses_own(IN(SurfacePoint) surface, IN(LightSample) light) {
  vec3 way = light.directional ? light.direction : light.offset - surface.rise;
  float height = dot_product(surface.geometric_normal, surface.rise);
  float fall = -dot_product(surface.geometric_normal, way);
  vec3 aside = surface.rise * fall + way * height;
  // Everything times the area and the fall, which may be 0.
  float b1 = surface.b1 * surface.area * fall + dot_product(aside, surface.across1);
  float b2 = surface.b2 * surface.area * fall + dot_product(aside, surface.across2);
  bool outside = b1 < 0.0f || b2 < 0.0f || b1 + b2 > surface.area * fall;
  return !outside;
}

// Puts the ray that has to get through for a light into `visit`, and tells which it is: to the light (PHASE_SHADOW), or, where
// the triangle faces away, first to the rounded surface above it (PHASE_RISE), unless that `rise_is_free`. `direction`, `offset`
// and `directional` are LightSample's.
uint aim_ray(IN(SurfacePoint) surface, IN(vec3) direction, IN(vec3) offset, IN(bool) directional, IN(bool) rise_is_free,
             INOUT(LightVisit) visit) {
  bool raised = dot_product(surface.geometric_normal, direction) <= 0.0f;
  bool rises_first = raised && !rise_is_free;
  vec3 origin = spawn_origin(surface, raised ? surface.geometric_normal : direction);
  vec3 above = raised_origin(surface);
  if (raised && rise_is_free) origin = above;
  // Towards a point light the ray ends at t = 1, at the light; the offset of its start is taken into account.
  vec3 way = directional ? direction : offset + (surface.position - origin);
  visit.ray = Ray(origin, rises_first ? above - origin : way);
  visit.t_min = 0.0f;
  visit.after_triangle = NONE;
  visit.t_max = directional && !rises_first ? LARGEST_FLOAT : 1.0f;
  visit.optical_depth = vec3(0.0f);
  return rises_first ? PHASE_RISE : PHASE_SHADOW;
}

// Asks the lights from visit.next_light on, up to the first whose light has to be proven by a ray: that is put into `visit`,
// and visit.value is what the light adds by the surface alone; the phase is aim_ray's. Lights that need no such ray are
// added to `sum`. PHASE_LIGHT: no light is left, or a loop limit cut the search off and visit.next_light says where.
// With `rise_is_free` the rise for the light before the next has been asked for.
uint ask_lights(IN(SurfacePoint) surface, IN(ShadingTerms) terms, IN(vec3) to_viewer, IN(bool) rise_is_free, INOUT(LightVisit) visit,
                INOUT(vec3) sum) {
  if (rise_is_free) visit.next_light--;
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
      bool faces = dot_product(surface.geometric_normal, light.direction) > 0.0f;
      bool lit = (faces || (rises && !crosses_own(surface, light))) && cosine > 0.0f && max3(light.irradiance) > 0.0f;
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
  uint asked = aim_ray(surface, direction, offset, directional, rise_is_free, visit);
  visit.value = value;
  return found ? asked : PHASE_LIGHT;
}

// Whether all lights have been asked.
bool lights_are_done(IN(LightVisit) visit) { return visit.next_light >= steering_constants().light_count; }

#endif
