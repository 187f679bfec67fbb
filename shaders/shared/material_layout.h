// A material and a light as the device reads them: whole RGBA32UI texels, scalar layout. Read by C++ and GLSL alike.
// The fields mean what those of src/scene/material.h and light.h mean.
#ifndef VERNIER_SHARED_MATERIAL_LAYOUT_H
#define VERNIER_SHARED_MATERIAL_LAYOUT_H

#include "shared/glsl.h"
#include "shared/light_kinds.h"
#include "shared/material_flags.h"

#ifdef __cplusplus
namespace vernier {
using glm::uint;
using glm::vec3;
using glm::vec4;
#endif

struct DeviceMaterial {
  vec4 base_color;
  vec3 specular;
  float roughness;  // blinn: the exponent
  vec3 reflection;
  float metallic;
  vec3 emission;
  float ior;
  vec3 transmission;
  float alpha_cutoff;
  vec3 absorption;  // per unit of the traced space
  float normal_scale;
  vec3 ambient;
  float occlusion_strength;
  uint flags;  // workflow | alpha mode << MATERIAL_ALPHA_SHIFT | MATERIAL_*
  float specular_strength;
  uint textured_slots;  // bit TEXTURE_SLOT_*: the slot has a texture
  uint free_word;
};

// One per slot, after the material's own texels.
struct DeviceTextureUse {
  uint texture;  // or NONE
  uint uv_set;
  float m00, m10;  // columns of uv_from_vertex_uv
  float m01, m11;
  float m02, m12;
};

struct DeviceLight {
  vec3 position;  // units
  uint kind;
  vec3 direction;
  float range;    // units; the largest float
  vec3 intensity;  // candela / metres_per_unit^2, so that intensity / distance^2 in units is lux; directional: lux
  float cos_outer;
  float cone_scale;  // 1 / max(cos_inner - cos_outer, 1/1024)
  uint free_word_0, free_word_1, free_word_2;
};

#define MATERIAL_OWN_TEXELS 8u
#define TEXTURE_USE_TEXELS 2u
#define MATERIAL_TEXELS (MATERIAL_OWN_TEXELS + TEXTURE_USE_TEXELS * uint(TEXTURE_SLOT_COUNT))
#define LIGHT_TEXELS 4u

// Word 3 of a texture: format | wrap_u << 4 | wrap_v << 6 | filter << 8 | filter of the file << 9.
#define TEXTURE_FORMAT_MASK 15u
#define TEXTURE_WRAP_U_SHIFT 4u
#define TEXTURE_WRAP_V_SHIFT 6u
#define TEXTURE_FILTER_SHIFT 8u
#define TEXTURE_FILE_FILTER_SHIFT 9u
// Words before the first texel: the sRGB curve.
#define SRGB_CURVE_WORDS 256u

#ifdef __cplusplus
static_assert(sizeof(DeviceMaterial) == 16 * MATERIAL_OWN_TEXELS);
static_assert(sizeof(DeviceTextureUse) == 16 * TEXTURE_USE_TEXELS);
static_assert(sizeof(DeviceLight) == 16 * LIGHT_TEXELS);
}  // namespace vernier
#endif

#endif
