#include "effects/material_terms.h"

#include <algorithm>

namespace vernier {
namespace {

// NaN is unequal to everything, so it counts as "can be other than zero" throughout.
bool differs(const glm::vec3& value, float from) {
  return value.x != from || value.y != from || value.z != from;
}

float largest(const glm::vec3& value) {
  return std::max({value.x, value.y, value.z});
}

bool textured(const Material& material, int slot) {
  return material.textures[slot].texture >= 0;
}

// The terms that metallic-roughness and specular-glossiness share; F0, F90, gloss as in shaders/README.md.
struct PhysicalTerms {
  bool f0 = false;
  bool f90 = false;
  bool gloss = false;          // gloss can be above 0
  bool gloss_below_1 = false;  // gloss can be below 1
  bool diffuse = false;
  bool transmission = false;
  bool always_transmissive = false;  // at every hit
};

// Transmission is a product of the base colour and factors that no texel and no vertex colour can make 0.
bool transmissive_everywhere(const Material& material, bool vertex_colors) {
  const bool textures = textured(material, TEXTURE_SLOT_BASE_COLOR) || textured(material, TEXTURE_SLOT_SURFACE) ||
                        textured(material, TEXTURE_SLOT_TRANSMISSION);
  constexpr float kNoUnderflow = 1e-30f;
  return !vertex_colors && !textures && material.metallic == 0.0f &&
         largest(glm::vec3(material.base_color)) * material.transmission.x >= kNoUnderflow;
}

PhysicalTerms metallic_roughness_terms(const Material& material, bool base, bool vertex_colors) {
  const bool surface = textured(material, TEXTURE_SLOT_SURFACE);
  const bool metal = material.metallic != 0.0f;
  const bool dielectric = material.metallic != 1.0f || surface;
  const bool strength = material.specular_strength != 0.0f;
  const bool transmissive = differs(material.transmission, 0.0f);
  const bool not_only_transmissive =
      differs(material.transmission, 1.0f) || textured(material, TEXTURE_SLOT_TRANSMISSION);
  PhysicalTerms terms;
  terms.f0 = (dielectric && strength && material.ior != 1.0f && differs(material.specular, 0.0f)) || (metal && base);
  terms.f90 = (dielectric && strength) || metal;
  terms.gloss = material.roughness != 1.0f || surface;
  terms.gloss_below_1 = material.roughness != 0.0f && (metal || not_only_transmissive);
  terms.diffuse = base && dielectric && not_only_transmissive;
  terms.transmission = base && dielectric && transmissive;
  terms.always_transmissive = terms.transmission && transmissive_everywhere(material, vertex_colors);
  return terms;
}

PhysicalTerms specular_glossiness_terms(const Material& material, bool base) {
  PhysicalTerms terms;
  terms.f0 = differs(material.specular, 0.0f);
  terms.f90 = terms.f0;
  terms.gloss = material.roughness != 1.0f;
  terms.gloss_below_1 = material.roughness != 0.0f || textured(material, TEXTURE_SLOT_SURFACE);
  terms.diffuse = base;
  return terms;
}

// Whether a transmissive surface reflects by Fresnel's terms: not where nothing is refracted (shaders/fresnel.glsl).
bool has_boundary(const Material& material) {
  return material.ior != 1.0f;
}

void add_physical(MaterialTerms& terms, const PhysicalTerms& physical, const Material& material) {
  terms.diffuse = physical.diffuse;
  terms.specular = physical.f0;
  terms.ambient = physical.diffuse || (physical.f0 && physical.gloss_below_1);
  const bool opaque_mirror = physical.gloss && (physical.f0 || physical.f90) && !physical.always_transmissive;
  terms.mirror = opaque_mirror || (physical.transmission && (physical.f0 || has_boundary(material)));
  terms.transmission = physical.transmission;
}

void add_blinn(MaterialTerms& terms, const Material& material) {
  terms.diffuse = terms.base;
  terms.specular = differs(material.specular, 0.0f);
  terms.ambient = differs(material.ambient, 0.0f);
  terms.transmission = differs(material.transmission, 0.0f);
  const bool transmissive_mirror = terms.transmission && has_boundary(material);
  const bool opaque_mirror = material.fresnel_reflection && !(largest(material.transmission) > 0.0f);
  terms.mirror = differs(material.reflection, 0.0f) || opaque_mirror || transmissive_mirror;
}

bool alpha_is_textured(const Material& material) {
  return textured(material, material.workflow == Workflow::blinn ? TEXTURE_SLOT_ALPHA : TEXTURE_SLOT_BASE_COLOR);
}

void add_alpha(MaterialTerms& terms, const Material& material, bool vertex_colors) {
  const bool varies = vertex_colors || alpha_is_textured(material);
  terms.cut_out =
      material.alpha_mode == AlphaMode::mask && (varies || !(material.base_color.w >= material.alpha_cutoff));
  terms.see_through = material.alpha_mode == AlphaMode::blend && (varies || !(material.base_color.w >= 1.0f));
}

// Nothing but the base colour is shown; shadow rays may still ask for the transmission.
MaterialTerms keep_unlit(const MaterialTerms& lit) {
  MaterialTerms terms;
  terms.base = lit.base;
  terms.transmission = lit.transmission;
  terms.absorption = lit.absorption;
  terms.cut_out = lit.cut_out;
  terms.see_through = lit.see_through;
  return terms;
}

bool base_color_counts(const Material& material, const MaterialTerms& terms) {
  const bool alpha = material.workflow != Workflow::blinn && material.base_color.w != 0.0f;
  return terms.base || (alpha && (terms.cut_out || terms.see_through));
}

unsigned lit_texture_slots(const Material& material, const MaterialTerms& terms) {
  const bool blinn = material.workflow == Workflow::blinn;
  const bool metallic_roughness = material.workflow == Workflow::metallic_roughness;
  const bool specular_color = differs(material.specular, 0.0f);
  bool surface = specular_color || material.roughness != 1.0f;
  if (blinn) {
    surface = specular_color || differs(material.reflection, 0.0f);
  } else if (metallic_roughness) {
    surface = material.metallic != 0.0f || material.roughness != 0.0f;
  }
  const bool transmission = metallic_roughness && terms.base && differs(material.transmission, 0.0f);
  const bool specular =
      blinn ? specular_color && material.exponent != 0.0f : metallic_roughness && material.specular_strength != 0.0f;
  const bool tint = blinn ? terms.ambient : metallic_roughness && specular_color;
  const bool occlusion = terms.ambient && material.occlusion_strength != 0.0f;
  return unsigned{surface} << TEXTURE_SLOT_SURFACE | unsigned{occlusion} << TEXTURE_SLOT_OCCLUSION |
         unsigned{terms.emission} << TEXTURE_SLOT_EMISSION | unsigned{transmission} << TEXTURE_SLOT_TRANSMISSION |
         unsigned{specular} << TEXTURE_SLOT_SPECULAR | unsigned{tint} << TEXTURE_SLOT_SPECULAR_COLOR;
}

}  // namespace

MaterialTerms material_terms(const Material& material, const MaterialUsage& usage) {
  MaterialTerms terms;
  terms.base = differs(glm::vec3(material.base_color), 0.0f);
  if (material.workflow == Workflow::blinn) {
    add_blinn(terms, material);
  } else if (material.workflow == Workflow::specular_glossiness) {
    add_physical(terms, specular_glossiness_terms(material, terms.base), material);
  } else {
    add_physical(terms, metallic_roughness_terms(material, terms.base, usage.vertex_colors), material);
  }
  terms.absorption = terms.transmission && !material.thin_walled && differs(material.absorption, 0.0f);
  terms.emission = differs(material.emission, 0.0f);
  add_alpha(terms, material, usage.vertex_colors);
  return material.unlit ? keep_unlit(terms) : terms;
}

unsigned counted_texture_slots(const Material& material, const MaterialTerms& terms) {
  unsigned slots = 1u << TEXTURE_SLOT_NORMAL;  // the shading normal is an AOV of every material, unlit or not
  slots |= unsigned{base_color_counts(material, terms)} << TEXTURE_SLOT_BASE_COLOR;
  const bool alpha = material.workflow == Workflow::blinn && material.base_color.w != 0.0f;
  slots |= unsigned{alpha && (terms.cut_out || terms.see_through)} << TEXTURE_SLOT_ALPHA;
  // An unlit material's shadow may be tinted by a textured transmission, and that needs every texture of it.
  if (!material.unlit || terms.transmission) {
    slots |= lit_texture_slots(material, terms);
  }
  for (int slot = 0; slot < TEXTURE_SLOT_COUNT; ++slot) {
    if (!textured(material, slot)) {
      slots &= ~(1u << slot);
    }
  }
  return slots;
}

}  // namespace vernier
