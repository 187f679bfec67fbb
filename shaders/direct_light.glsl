// Light that reaches a surface straight from the scene's lights. shaders/README.md, Image formation 5.4.
#ifndef VERNIER_DIRECT_LIGHT_GLSL
#define VERNIER_DIRECT_LIGHT_GLSL

#include "blinn.glsl"
#include "light.glsl"
#include "shadow.glsl"
#include "spawn_ray.glsl"

// What the light adds without its shadow: diffuse and highlight.
vec3 reflected_light(IN(SurfacePoint) surface, IN(ShadingTerms) terms, IN(vec3) to_viewer, IN(LightSample) light, IN(float) cosine) {
  vec3 reflected = terms.diffuse * (cosine / PI);
  if (effect_on(EFFECT_SPECULAR)) {
    float highlight = blinn_highlight(surface.normal, light.direction, to_viewer, terms.exponent);
    reflected += terms.specular * (highlight * (terms.cosine ? cosine : 1.0f));
  }
  return reflected * light.irradiance;
}

// Sum over all lights. `wanted` = false spares the work (lanes in lockstep still pass through).
Transmittance direct_light(IN(SurfacePoint) surface, IN(ShadingTerms) terms, IN(vec3) to_viewer, IN(bool) wanted,
                           INOUT(RayCounts) counts) {
  Transmittance sum = Transmittance(vec3(0.0f), true);
  uint light_count = steering_constants().light_count;
  uint index = 0u;
  // The second condition lets no compiler take `index >= light_count` for true behind the loop (traverse_bvh.glsl).
  for (; index < light_count && index < TRAVERSAL_STEP_LIMIT; index++) {
    LightSample light = sample_light(fetch_light(index), surface.position);
    float cosine = dot_product(surface.normal, light.direction);
    bool lit = wanted && cosine > 0.0f && dot_product(surface.geometric_normal, light.direction) > 0.0f && max3(light.irradiance) > 0.0f;
    vec3 reflected = lit ? reflected_light(surface, terms, to_viewer, light, cosine) : vec3(0.0f);
    if (effect_on(EFFECT_SHADOWS) && max3(reflected) > 0.0f) {
      vec3 origin = spawn_origin(surface, light.direction);
      // Towards a point light the ray ends at t = 1, at the light; the offset of its start is taken into account.
      Ray ray = Ray(origin, light.directional ? light.direction : light.offset + (surface.position - origin));
      Transmittance shadow = transmittance(ray, light.directional ? LARGEST_FLOAT : 1.0f, counts);
      counts.shadow++;
      reflected *= shadow.value;
      sum.finished = sum.finished && shadow.finished;
    }
    sum.value += reflected;
  }
  sum.finished = sum.finished && index >= light_count;
  return sum;
}

#endif
