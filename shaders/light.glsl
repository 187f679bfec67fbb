// Punctual lights. shaders/README.md, Image formation 5.4.
#ifndef VERNIER_LIGHT_GLSL
#define VERNIER_LIGHT_GLSL

#include "effect_runs.glsl"
#include "material.glsl"

// A light as a surface point sees it.
struct LightSample {
  vec3 direction;   // to the light: unit
  vec3 irradiance;  // at normal incidence, lux
  vec3 offset;      // to the light, units; directional: the same as direction
  bool directional;
};

// Light number `index` as it lies in memory.
DeviceLight fetch_light(IN(uint) index) {
  uvec4 t0 = load_light(index * LIGHT_TEXELS);
  vec4 t1 = float_texel(load_light(index * LIGHT_TEXELS + 1u));
  vec4 t2 = float_texel(load_light(index * LIGHT_TEXELS + 2u));
  vec4 t3 = float_texel(load_light(index * LIGHT_TEXELS + 3u));
  DeviceLight light;
  light.position = first_three(float_texel(t0));
  light.kind = t0.w;
  light.direction = first_three(t1);
  light.range = t1.w;
  light.intensity = first_three(t2);
  light.cos_outer = t2.w;
  light.cone_scale = t3.x;
  return light;
}

// `light` seen from `position` (units): with attenuation, cone and range. Black where the light is at the position itself,
// and where lights of its kind are off.
LightSample sample_light(IN(DeviceLight) light, IN(vec3) position) {
  bool directional = light.kind == LIGHT_DIRECTIONAL;
  if (directional ? !effect_on(EFFECT_DIRECTIONAL_LIGHTS) : !effect_on(EFFECT_POINT_LIGHTS)) {
    return LightSample(vec3(0.0f), vec3(0.0f), vec3(0.0f), directional);
  }
  note_run(directional ? EFFECT_DIRECTIONAL_LIGHTS : EFFECT_POINT_LIGHTS);
  if (directional) return LightSample(-light.direction, light.intensity, -light.direction, true);
  vec3 offset = light.position - position;
  vec3 direction = unit_vector(offset);
  float distance = dot_product(offset, direction);
  // Divided twice: the square of a very small or large distance would leave the range of floats.
  vec3 irradiance = distance > 0.0f ? light.intensity / distance / distance : vec3(0.0f);
  float relative = distance / light.range;
  irradiance *= clamp(1.0f - relative * relative * relative * relative, 0.0f, 1.0f);
  if (effect_on(EFFECT_SPOT_LIGHTS) && light.kind == LIGHT_SPOT) {
    note_run(EFFECT_SPOT_LIGHTS);
    float cone = clamp((dot_product(light.direction, -direction) - light.cos_outer) * light.cone_scale, 0.0f, 1.0f);
    irradiance *= cone * cone;
  }
  return LightSample(direction, irradiance, offset, false);
}

#endif
