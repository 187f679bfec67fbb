// From a material and its textures to the terms of the shading model: the mapping of metallic-roughness,
// specular-glossiness and MTL to Blinn's terms. shaders/README.md, Image formation 4.
#ifndef VERNIER_SHADING_TERMS_GLSL
#define VERNIER_SHADING_TERMS_GLSL

#include "fresnel.glsl"
#include "surface.glsl"

const float PI = 3.14159265358979323846f;

struct ShadingTerms {
  vec3 base;          // base colour
  vec3 diffuse;       // Lambert reflectance
  vec3 specular;      // factor of the highlight
  float exponent;     // of the highlight
  bool cosine;        // the highlight is weighed by the cosine at the surface
  vec3 ambient;       // reflectance of ambient light
  vec3 mirror;        // mirror weight at normal incidence
  vec3 mirror_grazing;  // and at grazing
  vec3 transmission;  // tint of what goes through; not zero: transmissive
  float boundary_normal;   // of a transmissive surface: what is kept from going through at normal incidence
  float boundary_grazing;  // and at grazing
  vec3 emission;
};

// Exponent of the Blinn lobe whose width matches a microfacet roughness alpha = roughness^2, at most that of
// alpha = 2^-5 (2046), so that highlights of point lights are no sub-pixel sparkles: 2 / alpha^2 - 2. Walter et al. 2007, "Microfacet Models for Refraction through Rough Surfaces";
// Karis 2013, "Specular BRDF Reference".
float exponent_of_roughness(IN(float) roughness) {
  float alpha = max(roughness * roughness, 0.03125f);
  return 2.0f / (alpha * alpha) - 2.0f;
}

// Terms of a glTF surface from base colour, F0, F90 and roughness: what is not mirrored sharply (gloss) is ambient. Of the share
// that is `clear`, which refracts sharply whatever the roughness, all is mirrored.
ShadingTerms microfacet_terms(IN(vec3) base, IN(vec3) diffuse, IN(vec3) f0, IN(vec3) f90, IN(float) roughness, IN(float) clear) {
  ShadingTerms terms;
  float sharp = (1.0f - roughness) * (1.0f - roughness);
  float gloss = sharp + (1.0f - sharp) * clear;
  terms.base = base;
  terms.diffuse = diffuse;
  terms.exponent = exponent_of_roughness(roughness);
  // Distribution (e + 2) / (2 pi) times the implicit geometry term N.L N.V, over 4 N.L N.V (Karis 2013).
  terms.specular = f0 * ((terms.exponent + 2.0f) / (8.0f * PI));
  terms.cosine = true;
  terms.ambient = diffuse + f0 * ((1.0f - sharp) * (1.0f - clear));
  terms.mirror = f0 * gloss;
  terms.mirror_grazing = f90 * gloss;
  terms.transmission = vec3(0.0f);
  terms.boundary_normal = 0.0f;
  terms.boundary_grazing = 0.0f;
  terms.emission = vec3(0.0f);
  return terms;
}

ShadingTerms metallic_roughness_terms(IN(DeviceMaterial) material, IN(SlotTexels) texels, IN(vec3) base) {
  float metallic = material.metallic * texels.surface.z;
  float roughness = material.roughness * texels.surface.y;
  float strength = material.specular_strength * texels.specular.w;
  vec3 color = material.specular * first_three(texels.specular_color);
  float transmission = material.transmission.x * texels.transmission.x;
  vec3 dielectric = min(dielectric_f0(material.ior) * color, vec3(1.0f)) * strength;
  vec3 f0 = mix(dielectric, base, metallic);
  vec3 f90 = vec3(mix(strength, 1.0f, metallic));
  vec3 diffuse = base * ((1.0f - metallic) * (1.0f - transmission) * (1.0f - max3(dielectric)));
  float clear = transmission * (1.0f - metallic);
  ShadingTerms terms = microfacet_terms(base, diffuse, f0, f90, roughness, clear);
  terms.transmission = base * clear;
  terms.boundary_normal = max3(dielectric);
  terms.boundary_grazing = strength;
  return terms;
}

ShadingTerms specular_glossiness_terms(IN(DeviceMaterial) material, IN(SlotTexels) texels, IN(vec3) base) {
  vec3 f0 = min(material.specular * first_three(texels.surface), vec3(1.0f));
  float roughness = 1.0f - (1.0f - material.roughness) * texels.surface.w;
  vec3 f90 = vec3(max3(f0) > 0.0f ? 1.0f : 0.0f);
  return microfacet_terms(base, base * (1.0f - max3(f0)), f0, f90, roughness, 0.0f);
}

ShadingTerms mtl_terms(IN(DeviceMaterial) material, IN(SlotTexels) texels, IN(vec3) base, IN(vec3) color) {
  vec3 texel = first_three(texels.surface);
  ShadingTerms terms;
  terms.base = base;
  terms.diffuse = base;
  terms.specular = material.specular * texel / PI;
  terms.exponent = material.roughness * texels.specular.x;
  terms.cosine = false;
  terms.ambient = material.ambient * first_three(texels.specular_color) * color;
  terms.boundary_normal = dielectric_f0(material.ior);
  terms.boundary_grazing = 1.0f;
  bool fresnel_glass = has_flag(material, MATERIAL_FRESNEL_REFLECTION) && is_transmissive(material);
  terms.mirror = fresnel_glass ? vec3(terms.boundary_normal) : material.reflection * texel;
  terms.mirror_grazing = has_flag(material, MATERIAL_FRESNEL_REFLECTION) ? vec3(1.0f) : terms.mirror;
  terms.transmission = material.transmission;
  terms.emission = vec3(0.0f);
  return terms;
}

// The terms of a surface with the texels of its slots and vertex colour `color`.
ShadingTerms shading_terms(IN(DeviceMaterial) material, IN(SlotTexels) texels, IN(vec3) color) {
  vec3 base = first_three(material.base_color) * first_three(texels.base_color) * color;
  uint workflow = workflow_of(material);
  ShadingTerms terms;
  if (workflow == WORKFLOW_METALLIC_ROUGHNESS) {
    terms = metallic_roughness_terms(material, texels, base);
  } else if (workflow == WORKFLOW_SPECULAR_GLOSSINESS) {
    terms = specular_glossiness_terms(material, texels, base);
  } else {
    terms = mtl_terms(material, texels, base, color);
  }
  if (effect_on(EFFECT_EMISSION)) terms.emission = material.emission * first_three(texels.emission);
  terms.ambient *= 1.0f + material.occlusion_strength * (texels.occlusion.x - 1.0f);
  return terms;
}

#endif
