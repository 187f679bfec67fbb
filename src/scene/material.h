#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <string>

#include "shared/material_flags.h"

namespace vernier {

/// A texture as a material uses it. `texture` indexes Scene::textures, -1 for none.
/// The lookup is at `uv_from_vertex_uv * (u, v, 1)` of UV set `uv_set`, v downwards as in glTF
/// ((0, 0) is the first texel of the first row).
struct TextureUse {
  int texture = -1;
  std::uint32_t uv_set = 0;
  glm::mat3x2 uv_from_vertex_uv = glm::mat3x2(1.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f);
};

/// How `base_color`, `specular`, `roughness` and the texture slots are to be read.
enum class Workflow : std::uint32_t {
  metallic_roughness = WORKFLOW_METALLIC_ROUGHNESS,    ///< glTF 2.0 core
  specular_glossiness = WORKFLOW_SPECULAR_GLOSSINESS,  ///< KHR_materials_pbrSpecularGlossiness
  blinn = WORKFLOW_BLINN                               ///< MTL: the terms of the shading model themselves
};

/// How alpha is used. mask: a hit with alpha < alpha_cutoff is none. blend: alpha weighs this surface, 1 - alpha what
/// lies behind.
enum class AlphaMode : std::uint32_t { opaque = ALPHA_OPAQUE, mask = ALPHA_MASK, blend = ALPHA_BLEND };

/// One material. All colours linear Rec.709; factors multiply the texture of their slot; without a texture they stand
/// alone. What each field does to the picture is defined in shaders/README.md, "Image formation".
struct Material {
  std::string name;
  Workflow workflow = Workflow::metallic_roughness;
  glm::vec4 base_color = glm::vec4(1.0f);  ///< base colour | diffuse | Kd; a: opacity in [0, 1]
  glm::vec3 specular = glm::vec3(1.0f);    ///< KHR_materials_specular colour times factor | specular colour | Ks
  float specular_strength = 1.0f;  ///< KHR_materials_specular specularFactor: scales F90 of dielectrics; others 1
  float metallic = 0.0f;           ///< [0, 1], metallic_roughness only
  float roughness = 1.0f;          ///< [0, 1] | 1 - glossiness; unused by blinn
  float exponent = 0.0f;           ///< Ns, blinn only, >= 0
  glm::vec3 reflection = glm::vec3(0.0f);    ///< mirror colour at normal incidence, blinn only
  glm::vec3 emission = glm::vec3(0.0f);      ///< radiance, cd/m^2; strength multiplied in
  glm::vec3 transmission = glm::vec3(0.0f);  ///< part of the light that goes through: factor (grey) | Tf of glass
  float ior = 1.5f;                          ///< index of refraction inside, > 0
  glm::vec3 absorption = glm::vec3(0.0f);    ///< Beer-Lambert coefficient inside, per metre
  glm::vec3 ambient = glm::vec3(0.0f);       ///< Ka, blinn only
  AlphaMode alpha_mode = AlphaMode::opaque;
  float alpha_cutoff = 0.5f;
  float normal_scale = 1.0f;
  float occlusion_strength = 1.0f;
  bool double_sided = false;  ///< kept for reports: both sides are always traced
  bool unlit = false;         ///< show base_color as it is
  bool thin_walled = true;    ///< transmission goes straight through (no KHR_materials_volume thickness)
  /// blinn (illum 4, 5, 7, 9): mirrors by Schlick from `reflection` to white at grazing, glass by Fresnel's terms
  bool fresnel_reflection = false;
  std::array<TextureUse, TEXTURE_SLOT_COUNT> textures;  ///< by TEXTURE_SLOT_*
};

}  // namespace vernier
