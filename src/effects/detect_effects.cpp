#include "effects/detect_effects.h"

#include <array>
#include <bit>
#include <cmath>
#include <sstream>

#include "effects/effect_names.h"
#include "effects/fixed_effects.h"
#include "effects/needed_depth.h"
#include "effects/seen_materials.h"

namespace vernier {
namespace {

struct SlotEffect {
  unsigned slot;
  std::uint32_t bit;
  const char* what;
};

constexpr std::array<SlotEffect, TEXTURE_SLOT_COUNT> kSlotEffects = {{
    {TEXTURE_SLOT_BASE_COLOR, EFFECT_BASE_COLOR_TEXTURE, "base colour"},
    {TEXTURE_SLOT_SURFACE, EFFECT_SURFACE_TEXTURE, "surface"},
    {TEXTURE_SLOT_NORMAL, EFFECT_NORMAL_TEXTURE, "normal"},
    {TEXTURE_SLOT_OCCLUSION, EFFECT_OCCLUSION_TEXTURE, "occlusion"},
    {TEXTURE_SLOT_EMISSION, EFFECT_EMISSION_TEXTURE, "emission"},
    {TEXTURE_SLOT_TRANSMISSION, EFFECT_OTHER_TEXTURES, "transmission"},
    {TEXTURE_SLOT_SPECULAR, EFFECT_OTHER_TEXTURES, "specular"},
    {TEXTURE_SLOT_SPECULAR_COLOR, EFFECT_OTHER_TEXTURES, "specular or ambient colour"},
    {TEXTURE_SLOT_ALPHA, EFFECT_OTHER_TEXTURES, "alpha"},
}};

bool is_zero(const glm::vec3& value) {
  return value == glm::vec3(0.0f);
}

std::string to_text(const glm::vec3& value) {
  std::ostringstream text;
  const glm::vec3 shown = value + 0.0f;  // without -0
  text << shown.x << ", " << shown.y << ", " << shown.z;
  return text.str();
}

std::uint32_t kind_bit(LightKind kind) {
  if (kind == LightKind::directional) {
    return EFFECT_DIRECTIONAL_LIGHTS;
  }
  return kind == LightKind::spot ? EFFECT_SPOT_LIGHTS : EFFECT_POINT_LIGHTS;
}

// Why a light does not shine on anything; empty where it may.
std::string why_dark(const Light& light, const WorldBounds& box) {
  if (is_zero(light.intensity)) return "its intensity is 0";
  if (light.kind == LightKind::directional || (light.range != 0.0 && light_reaches(light, box))) return "";
  std::ostringstream text;
  text << "its range of " << light.range << " m ends before every triangle";
  return text.str();
}

void detect_lights(EffectSet& effects, const Scene& scene, const std::vector<SeenMaterial>& seen,
                   const WorldBounds& box, bool every_light_shines) {
  const SeenMaterial* lit = nullptr;
  const SeenMaterial* glossy = nullptr;
  for (const SeenMaterial& one : seen) {
    lit = !lit && (one.terms.diffuse || one.terms.specular) ? &one : lit;
    glossy = !glossy && one.terms.specular ? &one : glossy;
  }
  for (std::size_t index = 0; lit && index < scene.lights.size(); ++index) {
    const Light& light = scene.lights[index];
    const std::string dark = why_dark(light, box);
    if (!dark.empty() && !every_light_shines) {
      continue;
    }
    const std::string name = label_of("light", index, light.name);
    const auto falls_on = [&](const SeenMaterial& one) {
      return dark.empty() ? name + " falls on " + one.label : name + ": " + dark;
    };
    switch_on(effects, kind_bit(light.kind), falls_on(*lit));
    switch_on(effects, EFFECT_SHADOWS, falls_on(*lit));
    if (glossy) {
      switch_on(effects, EFFECT_SPECULAR, falls_on(*glossy));
    }
  }
}

void detect_coverage(EffectSet& effects, const SeenMaterial& seen) {
  const Material& material = seen.material;
  std::string lets_through;
  if (seen.terms.transmission) {
    lets_through = seen.label + ": transmission " + to_text(material.transmission);
  }
  if (seen.terms.cut_out) {
    lets_through = seen.label + ": alpha can fall below its cutoff " + std::to_string(material.alpha_cutoff);
    switch_on(effects, EFFECT_ALPHA_MASK, lets_through);
  }
  if (seen.terms.see_through) {
    lets_through = seen.label + ": opacity can be below 1";
    switch_on(effects, EFFECT_ALPHA_BLEND, lets_through);
  }
  if (!lets_through.empty() && (effects.bits & EFFECT_SHADOWS)) {
    switch_on(effects, EFFECT_TINTED_SHADOWS, lets_through);
  }
}

void detect_bounces(EffectSet& effects, const SeenMaterial& seen, const Supposition& supposed) {
  const MaterialTerms& terms = seen.terms;
  const bool followed = supposed.max_bounces > 0 && !seen.material.unlit;
  if (terms.mirror && followed && !(seen.mirror_weight < supposed.cutoff)) {
    switch_on(effects, EFFECT_REFLECTION,
              seen.label + (terms.transmission ? ": reflects at its interface" : ": mirrors"));
  }
  if (terms.transmission && followed) {
    switch_on(effects, EFFECT_REFRACTION, seen.label + ": transmission " + to_text(seen.material.transmission));
  }
  // Shadow rays through a volume are absorbed too, whatever the number of bounces.
  if (terms.absorption && (followed || (effects.bits & EFFECT_TINTED_SHADOWS))) {
    switch_on(effects, EFFECT_ABSORPTION,
              seen.label + ": absorption " + to_text(seen.material.absorption) + " per metre");
  }
}

void detect_texture_format(EffectSet& effects, const Scene& scene, int texture) {
  const auto index = static_cast<std::size_t>(texture);
  const Texels* texels = scene.textures[index].texels.get();
  if (texels != nullptr && texels->format == TEXTURE_FORMAT_FLOAT) {
    switch_on(effects, EFFECT_FLOAT_TEXTURES, label_of("texture", index, scene.textures[index].name));
  }
}

void detect_textures(EffectSet& effects, const Scene& scene, const SeenMaterial& seen) {
  for (const SlotEffect& slot : kSlotEffects) {
    const bool unseen = slot.slot == TEXTURE_SLOT_OCCLUSION && !(effects.bits & EFFECT_AMBIENT);
    if ((seen.texture_slots & 1u << slot.slot) && !unseen) {
      const auto index = static_cast<std::size_t>(seen.material.textures[slot.slot].texture);
      const bool almost_flat = slot.slot == TEXTURE_SLOT_NORMAL && seen.bend == NormalMapBend::alike;
      switch_on(effects, slot.bit,
                seen.label + ": " + slot.what + " " + label_of("texture", index, scene.textures[index].name) +
                    (almost_flat ? ", the same all over, but not exactly flat" : ""));
      detect_texture_format(effects, scene, seen.material.textures[slot.slot].texture);
    }
  }
}

void detect_surface(EffectSet& effects, const SeenMaterial& seen) {
  const MaterialTerms& terms = seen.terms;
  if (seen.usage.vertex_normals) {
    switch_on(effects, EFFECT_SMOOTH_NORMALS, seen.label + " lies on triangles with vertex normals");
  }
  const bool ambient_is_tinted = terms.ambient && seen.material.workflow == Workflow::blinn;
  if (seen.usage.vertex_colors && (terms.base || ambient_is_tinted || terms.cut_out || terms.see_through)) {
    switch_on(effects, EFFECT_VERTEX_COLORS, seen.label + " lies on triangles with vertex colours");
  }
  if (terms.emission) {
    switch_on(effects, EFFECT_EMISSION, seen.label + ": emission " + to_text(seen.material.emission));
  }
  if (seen.material.unlit) {
    switch_on(effects, EFFECT_UNLIT, seen.label);
  }
}

// Where the ambient light comes from; empty when it is black.
std::string ambient_source(const Environment& environment) {
  if (environment.has_ambient_override) {
    return is_zero(environment.ambient) ? "" : "the ambient colour " + to_text(environment.ambient);
  }
  if (environment.texture >= 0) {
    return is_zero(environment.texture_scale) ? "" : "the environment image";
  }
  return is_zero(environment.sky) && is_zero(environment.ground) ? "" : "the background";
}

void detect_ambient(EffectSet& effects, const Environment& environment, const std::vector<SeenMaterial>& seen) {
  const std::string source = ambient_source(environment);
  for (const SeenMaterial& one : seen) {
    if (!source.empty() && one.terms.ambient) {
      switch_on(effects, EFFECT_AMBIENT, source + " falls on " + one.label);
    }
  }
}

void detect_view(EffectSet& effects, const Scene& scene, const Camera& camera) {
  const Environment& environment = scene.environment;
  if (environment.texture >= 0 && !is_zero(environment.texture_scale)) {
    const auto index = static_cast<std::size_t>(environment.texture);
    switch_on(effects, EFFECT_ENVIRONMENT_MAP, label_of("texture", index, scene.textures[index].name));
    detect_texture_format(effects, scene, environment.texture);
  }
  if (camera.orthographic) {
    switch_on(effects, EFFECT_ORTHOGRAPHIC, camera.name.empty() ? "the camera" : "camera " + camera.name);
  }
}

EffectSet detect_under(const Scene& scene, const Camera& camera, const SceneFacts& facts, const Supposition& supposed) {
  EffectSet effects = no_effects();
  const std::vector<SeenMaterial> seen = seen_materials(scene, facts, supposed);
  detect_view(effects, scene, camera);
  detect_lights(effects, scene, seen, facts.box, supposed.every_light_shines);
  detect_ambient(effects, scene.environment, seen);
  for (const SeenMaterial& one : seen) {
    detect_surface(effects, one);
    detect_coverage(effects, one);
    detect_bounces(effects, one, supposed);
    detect_textures(effects, scene, one);
  }
  for (const EffectNeed& need : effect_needs()) {
    if (effects.bits & need.effect) switch_on(effects, need.needed, need_reason(need));
  }
  return effects;
}

// An effect that is off and would be on if `supposed` held is off because it does not: `but` says what holds instead.
void explain_absence(EffectSet& effects, const EffectSet& supposed, const char* but) {
  for (std::size_t index = 0; index < effects.reasons.size(); ++index) {
    EffectReason& verdict = effects.reasons[index];
    const bool is_usual = verdict.reason == effect_names()[index].why_off;
    if (!verdict.on && is_usual && supposed.reasons[index].on) verdict.reason = supposed.reasons[index].reason + but;
  }
}

void explain_flat_normals(EffectSet& effects, const Scene& scene) {
  EffectReason& smooth = effects.reasons[std::countr_zero(EFFECT_SMOOTH_NORMALS)];
  for (std::size_t index = 0; !smooth.on && index < scene.meshes.size(); ++index) {
    if (!scene.meshes[index].flat_normals) continue;
    smooth.reason =
        label_of("mesh", index, scene.meshes[index].name) + ": its vertex normals are those of its triangles";
    return;
  }
}

}  // namespace

EffectSet detect_effects(const Scene& scene, const Camera& camera, int max_bounces, double cutoff) {
  const SceneFacts facts = scene_facts(scene);
  const Supposition actual{.max_bounces = max_bounces, .cutoff = cutoff};
  EffectSet effects = detect_under(scene, camera, facts, actual);
  const auto unless = [&](auto change, const char* but) {
    Supposition supposed = actual;
    change(supposed);
    explain_absence(effects, detect_under(scene, camera, facts, supposed), but);
  };
  unless([](Supposition& s) { s.max_bounces = 1; }, "; but no bounces are allowed");
  unless([](Supposition& s) { s.ior_differs = true; }, "; but its ior is that of what is around it");
  unless([](Supposition& s) { s.cutoff = 0.0; }, "; but always weaker than the cutoff");
  unless([](Supposition& s) { s.texels_vary = true; }, "; but its texels leave nothing of it");
  unless([](Supposition& s) { s.every_light_shines = true; }, "");
  unless([](Supposition& s) { s.every_material_used = true; }, "; but no triangle uses it");
  explain_flat_normals(effects, scene);
  const std::vector<SeenMaterial> seen = seen_materials(scene, facts, actual);
  effects.depth = needed_depth(effects.bits, seen, static_cast<std::uint32_t>(max_bounces), cutoff);
  effects.fixed = fixed_effects(scene, effects, seen);
  return effects;
}

}  // namespace vernier
