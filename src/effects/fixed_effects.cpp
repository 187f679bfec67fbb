#include "effects/fixed_effects.h"

#include <bit>

namespace vernier {
namespace {

EffectReason light_attenuation(const EffectSet& effects) {
  const EffectReason& spots = effects.reasons[std::countr_zero(EFFECT_SPOT_LIGHTS)];
  const EffectReason& lights = spots.on ? spots : effects.reasons[std::countr_zero(EFFECT_POINT_LIGHTS)];
  return {0, "light_attenuation", lights.on,
          lights.on ? lights.reason + ", weaker with the distance" : "no point or spot light falls on anything"};
}

EffectReason double_sided(std::span<const SeenMaterial> seen) {
  for (const SeenMaterial& one : seen) {
    if (one.material.double_sided) {
      return {0, "double_sided", true, one.label + " is marked so; rays meet both sides of every triangle anyway"};
    }
  }
  return {0, "double_sided", false, "no visible material is marked so; rays meet both sides of every triangle anyway"};
}

EffectReason texture_transform(const Scene& scene, std::span<const SeenMaterial> seen) {
  for (const SeenMaterial& one : seen) {
    for (int slot = 0; slot < TEXTURE_SLOT_COUNT; ++slot) {
      const TextureUse& use = one.material.textures[slot];
      if ((one.texture_slots & 1u << slot) == 0 || use.uv_from_vertex_uv == TextureUse{}.uv_from_vertex_uv) continue;
      const auto index = static_cast<std::size_t>(use.texture);
      return {0, "texture_transform", true,
              one.label + " moves, turns or scales " + label_of("texture", index, scene.textures[index].name)};
    }
  }
  return {0, "texture_transform", false, "no texture that counts is moved, turned or scaled"};
}

}  // namespace

std::vector<EffectReason> fixed_effects(const Scene& scene, const EffectSet& effects,
                                        std::span<const SeenMaterial> seen) {
  return {light_attenuation(effects), double_sided(seen), texture_transform(scene, seen)};
}

}  // namespace vernier
