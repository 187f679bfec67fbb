#include "effects/effect_names.h"

#include <array>
#include <bit>
#include <stdexcept>

namespace vernier {
namespace {

constexpr const char* kNoLight = "no light of this kind falls on a material that answers to light";

constexpr std::array<EffectName, EFFECT_COUNT> kNames = {{
    {EFFECT_SHADOWS, "shadows", "no light falls on a material that answers to light"},
    {EFFECT_TINTED_SHADOWS, "tinted_shadows", "no shadow rays, or no visible triangle lets light through"},
    {EFFECT_REFLECTION, "reflection", "no visible triangle mirrors"},
    {EFFECT_REFRACTION, "refraction", "transmission 0 on all visible triangles"},
    {EFFECT_ABSORPTION, "absorption", "no visible transmissive volume absorbs"},
    {EFFECT_ALPHA_MASK, "alpha_mask", "no alpha of a visible triangle in mode mask can fall below its cutoff"},
    {EFFECT_ALPHA_BLEND, "alpha_blend", "opacity 1 on all visible triangles in mode blend"},
    {EFFECT_SMOOTH_NORMALS, "smooth_normals", "no triangle has a normal at all three corners"},
    {EFFECT_VERTEX_COLORS, "vertex_colors", "no used triangle has vertex colours that scale anything"},
    {EFFECT_BASE_COLOR_TEXTURE, "base_color_texture", "no used material has a base colour texture that counts"},
    {EFFECT_SURFACE_TEXTURE, "surface_texture", "no used material has a surface texture that counts"},
    {EFFECT_NORMAL_TEXTURE, "normal_texture", "no used material has a normal texture"},
    {EFFECT_OCCLUSION_TEXTURE, "occlusion_texture", "no ambient light, or no occlusion texture of strength above 0"},
    {EFFECT_EMISSION_TEXTURE, "emission_texture", "no used material that emits has an emission texture"},
    {EFFECT_OTHER_TEXTURES, "other_textures", "no transmission, specular, ambient or alpha texture counts"},
    {EFFECT_POINT_LIGHTS, "point_lights", kNoLight},
    {EFFECT_SPOT_LIGHTS, "spot_lights", kNoLight},
    {EFFECT_DIRECTIONAL_LIGHTS, "directional_lights", kNoLight},
    {EFFECT_SPECULAR, "specular", "no light falls on a material with a highlight"},
    {EFFECT_AMBIENT, "ambient", "the ambient source is black, or no used material answers to it"},
    {EFFECT_EMISSION, "emission", "emission 0 on all visible triangles"},
    {EFFECT_UNLIT, "unlit", "no used material is unlit"},
    {EFFECT_ENVIRONMENT_MAP, "environment_map", "the environment has no image"},
    {EFFECT_ORTHOGRAPHIC, "orthographic", "the camera is perspective"},
    {EFFECT_FLOAT_TEXTURES, "float_textures", "no texture that counts has more than 8 bits per channel"},
}};

constexpr std::array<EffectNeed, 5> kNeeds = {{
    {EFFECT_TINTED_SHADOWS, EFFECT_SHADOWS, "what tints a shadow is met by shadow rays"},
    {EFFECT_ABSORPTION, EFFECT_REFRACTION, "rays are absorbed in the media that refraction takes them into"},
    {EFFECT_SPOT_LIGHTS, EFFECT_POINT_LIGHTS, "a spot light is a point light with a cone"},
    {EFFECT_OCCLUSION_TEXTURE, EFFECT_AMBIENT, "occlusion dims ambient light"},
    {EFFECT_EMISSION_TEXTURE, EFFECT_EMISSION, "its texels scale the emission"},
}};

std::size_t index_of(std::uint32_t bit) {
  const auto index = static_cast<std::size_t>(std::countr_zero(bit));
  if (!std::has_single_bit(bit) || index >= EFFECT_COUNT) {
    throw std::out_of_range("not an effect bit: " + std::to_string(bit));
  }
  return index;
}

void turn(EffectSet& effects, std::uint32_t bit, bool on, const std::string& reason) {
  EffectReason& verdict = effects.reasons.at(index_of(bit));
  if (verdict.on == on) {
    return;
  }
  verdict.on = on;
  verdict.reason = reason;
  effects.bits ^= bit;
}

}  // namespace

std::span<const EffectName> effect_names() {
  return kNames;
}

std::span<const EffectNeed> effect_needs() {
  return kNeeds;
}

std::string need_reason(const EffectNeed& need) {
  return std::string("needed by ") + effect_name(need.effect) + ": " + need.why;
}

const char* effect_name(std::uint32_t bit) {
  return kNames[index_of(bit)].name;
}

EffectSet no_effects() {
  EffectSet effects;
  effects.reasons.reserve(kNames.size());
  for (const EffectName& entry : kNames) {
    effects.reasons.push_back({entry.bit, entry.name, false, entry.why_off});
  }
  return effects;
}

void switch_on(EffectSet& effects, std::uint32_t bit, const std::string& reason) {
  turn(effects, bit, true, reason);
}

void switch_off(EffectSet& effects, std::uint32_t bit, const std::string& reason) {
  turn(effects, bit, false, reason);
}

}  // namespace vernier
