// A material as it lies in memory.
#ifndef VERNIER_MATERIAL_GLSL
#define VERNIER_MATERIAL_GLSL

#include "rounding.glsl"
#include "shared/material_flags.h"
#include "shared/material_layout.h"

// Four words as floats.
vec4 float_texel(IN(uvec4) words) {
  return vec4(uintBitsToFloat(words.x), uintBitsToFloat(words.y), uintBitsToFloat(words.z), uintBitsToFloat(words.w));
}

vec3 first_three(IN(vec4) v) { return vec3(v.x, v.y, v.z); }

// Material number `index` without its texture slots.
DeviceMaterial fetch_material(IN(uint) index) {
  uint first = index * MATERIAL_TEXELS;
  vec4 t1 = float_texel(load_material(first + 1u));
  vec4 t2 = float_texel(load_material(first + 2u));
  vec4 t3 = float_texel(load_material(first + 3u));
  vec4 t4 = float_texel(load_material(first + 4u));
  vec4 t5 = float_texel(load_material(first + 5u));
  vec4 t6 = float_texel(load_material(first + 6u));
  uvec4 t7 = load_material(first + 7u);
  DeviceMaterial material;
  material.base_color = float_texel(load_material(first));
  material.specular = first_three(t1);
  material.roughness = t1.w;
  material.reflection = first_three(t2);
  material.metallic = t2.w;
  material.emission = first_three(t3);
  material.ior = t3.w;
  material.transmission = first_three(t4);
  material.alpha_cutoff = t4.w;
  material.absorption = first_three(t5);
  material.normal_scale = t5.w;
  material.ambient = first_three(t6);
  material.occlusion_strength = t6.w;
  material.flags = t7.x;
  material.specular_strength = uintBitsToFloat(t7.y);
  material.textured_slots = t7.z;
  material.free_word = t7.w;
  return material;
}

// How material number `index` uses the texture of `slot`.
DeviceTextureUse fetch_texture_use(IN(uint) index, IN(uint) slot) {
  uint first = index * MATERIAL_TEXELS + MATERIAL_OWN_TEXELS + slot * TEXTURE_USE_TEXELS;
  uvec4 a = load_material(first);
  vec4 b = float_texel(load_material(first + 1u));
  return DeviceTextureUse(a.x, a.y, uintBitsToFloat(a.z), uintBitsToFloat(a.w), b.x, b.y, b.z, b.w);
}

// A use of UV set `uv_set` as it is.
DeviceTextureUse plain_use(IN(uint) uv_set) { return DeviceTextureUse(0u, uv_set, 1.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f); }

// Beer-Lambert coefficient of material number `index`, per unit.
vec3 fetch_absorption(IN(uint) index) { return first_three(float_texel(load_material(index * MATERIAL_TEXELS + 5u))); }

// WORKFLOW_* of a material; where all of the scene have one, the compiler knows it.
uint workflow_of(IN(DeviceMaterial) material) {
  if (WORKFLOWS == 1u << WORKFLOW_METALLIC_ROUGHNESS) return WORKFLOW_METALLIC_ROUGHNESS;
  if (WORKFLOWS == 1u << WORKFLOW_SPECULAR_GLOSSINESS) return WORKFLOW_SPECULAR_GLOSSINESS;
  if (WORKFLOWS == 1u << WORKFLOW_BLINN) return WORKFLOW_BLINN;
  return material.flags & MATERIAL_WORKFLOW_MASK;
}

// ALPHA_* of the material.
uint alpha_mode_of(IN(DeviceMaterial) material) {
  return (material.flags >> MATERIAL_ALPHA_SHIFT) & MATERIAL_ALPHA_MASK;
}

bool has_flag(IN(DeviceMaterial) material, IN(uint) flag) { return (material.flags & flag) != 0u; }

bool is_transmissive(IN(DeviceMaterial) material) { return max3(material.transmission) > 0.0f; }

// Whether it reflects and transmits the same at every angle.
bool is_fresnel_free(IN(DeviceMaterial) material) {
  return workflow_of(material) == WORKFLOW_BLINN && !has_flag(material, MATERIAL_FRESNEL_REFLECTION);
}

#endif
