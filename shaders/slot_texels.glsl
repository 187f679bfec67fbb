// The texels of a material's slots at a hit, looked up in one loop.
#ifndef VERNIER_SLOT_TEXELS_GLSL
#define VERNIER_SLOT_TEXELS_GLSL

#include "texture.glsl"
#include "triangle_point.glsl"

// One texel per slot that some workflow reads; (1, 1, 1, 1) where the material has no texture there.
struct SlotTexels {
  vec4 base_color;
  vec4 surface;
  vec4 normal;
  vec4 occlusion;
  vec4 emission;
  vec4 transmission;
  vec4 specular;
  vec4 specular_color;
  vec4 alpha;
  bool finished;  // false: cut off by a loop limit, the texels may not be used
};

// Slots that the effects switched on may read, as bits.
uint readable_slots() {
  uint slots = 0u;
  if (effect_on(EFFECT_BASE_COLOR_TEXTURE)) slots |= 1u << TEXTURE_SLOT_BASE_COLOR;
  if (effect_on(EFFECT_SURFACE_TEXTURE)) slots |= 1u << TEXTURE_SLOT_SURFACE;
  if (effect_on(EFFECT_NORMAL_TEXTURE)) slots |= 1u << TEXTURE_SLOT_NORMAL;
  if (effect_on(EFFECT_OCCLUSION_TEXTURE)) slots |= 1u << TEXTURE_SLOT_OCCLUSION;
  if (effect_on(EFFECT_EMISSION_TEXTURE)) slots |= 1u << TEXTURE_SLOT_EMISSION;
  if (effect_on(EFFECT_OTHER_TEXTURES)) {
    slots |= 1u << TEXTURE_SLOT_TRANSMISSION | 1u << TEXTURE_SLOT_SPECULAR | 1u << TEXTURE_SLOT_SPECULAR_COLOR |
             1u << TEXTURE_SLOT_ALPHA;
  }
  return slots;
}

// Those of a material without textures.
SlotTexels no_slot_texels() {
  vec4 one = vec4(1.0f);
  return SlotTexels(one, one, one, one, one, one, one, one, one, true);
}

// The effect that reads `slot`.
uint effect_of_slot(IN(int) slot) {
  if (slot == TEXTURE_SLOT_BASE_COLOR) return EFFECT_BASE_COLOR_TEXTURE;
  if (slot == TEXTURE_SLOT_SURFACE) return EFFECT_SURFACE_TEXTURE;
  if (slot == TEXTURE_SLOT_NORMAL) return EFFECT_NORMAL_TEXTURE;
  if (slot == TEXTURE_SLOT_OCCLUSION) return EFFECT_OCCLUSION_TEXTURE;
  if (slot == TEXTURE_SLOT_EMISSION) return EFFECT_EMISSION_TEXTURE;
  return EFFECT_OTHER_TEXTURES;
}

void set_slot(INOUT(SlotTexels) texels, IN(int) slot, IN(vec4) texel) {
  texels.base_color = slot == TEXTURE_SLOT_BASE_COLOR ? texel : texels.base_color;
  texels.surface = slot == TEXTURE_SLOT_SURFACE ? texel : texels.surface;
  texels.normal = slot == TEXTURE_SLOT_NORMAL ? texel : texels.normal;
  texels.occlusion = slot == TEXTURE_SLOT_OCCLUSION ? texel : texels.occlusion;
  texels.emission = slot == TEXTURE_SLOT_EMISSION ? texel : texels.emission;
  texels.transmission = slot == TEXTURE_SLOT_TRANSMISSION ? texel : texels.transmission;
  texels.specular = slot == TEXTURE_SLOT_SPECULAR ? texel : texels.specular;
  texels.specular_color = slot == TEXTURE_SLOT_SPECULAR_COLOR ? texel : texels.specular_color;
  texels.alpha = slot == TEXTURE_SLOT_ALPHA ? texel : texels.alpha;
}

// Texels at `point` of those `slots` (bits) that `material` has. One loop with one look-up in it: lanes in lockstep take as
// many rounds as the material with the most textures has, instead of one for every slot there is.
SlotTexels fetch_slot_texels(IN(TrianglePoint) point, IN(DeviceMaterial) material, IN(uint) slots) {
  SlotTexels texels = no_slot_texels();
  if (readable_slots() == 0u) return texels;
  uint left = material.textured_slots & slots & readable_slots();
  uint round = 0u;
  bool done = false;
  if (left != 0u) {
    for (;;) {
      if (!TEST_LAST && done) break;
      // A lane without a slot works on beside the others: at slot 0 it finds floats, at -1 numbers of textures, which are
      // denormals as floats (shared/bvh_record.h).
      int slot = max(findLSB(left), 0);
      left &= left - 1u;
      note_run(effect_of_slot(slot));
      DeviceTextureUse use = fetch_texture_use(point.vertices.w, uint(slot));
      vec2 uv = interpolated_uv(point, use.uv_set);
      vec2 place = vec2(use.m00 * uv.x + use.m01 * uv.y + use.m02, use.m10 * uv.x + use.m11 * uv.y + use.m12);
      set_slot(texels, slot, sample_texture(use.texture, place));
      round++;
      done = left == 0u || round >= uint(TEXTURE_SLOT_COUNT);
      if (TEST_LAST && done) break;
    }
  }
  texels.finished = left == 0u;
  return texels;
}

#endif
