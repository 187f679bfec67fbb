#include "reference/surface_terms.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "reference/fresnel.h"
#include "reference/vertex_values.h"

namespace vernier::reference {

namespace {

struct Lookup {
  const Scene& scene;
  const Triangle& triangle;
  const glm::dvec3& weights;

  glm::dvec4 rgba(std::size_t slot) const { return texture_at(scene, triangle, weights, slot); }
  glm::dvec3 rgb(std::size_t slot) const { return glm::dvec3(rgba(slot)); }
};

double max3(const glm::dvec3& v) {
  return std::max({v.x, v.y, v.z});
}

// What metallic-roughness and specular-glossiness have in common once F0, F90, roughness and metalness are known.
struct Reflectance {
  glm::dvec3 at_normal;
  double at_grazing;
  glm::dvec3 dielectric;  // f: F0 of the part that is no metal
  double strength;        // its F90
  double roughness;
  double metallic;
  double transmission;
};

void set_reflectance(SurfaceTerms& terms, const Reflectance& r) {
  const glm::dvec3 not_metal = terms.base * (1.0 - r.metallic);
  const double gloss = (1.0 - r.roughness) * (1.0 - r.roughness);
  const double alpha = std::max(r.roughness * r.roughness, 0x1p-5);
  const double clear = r.transmission * (1.0 - r.metallic);
  const double mirrored = 1.0 - (1.0 - gloss) * (1.0 - clear);
  terms.diffuse = not_metal * (1.0 - r.transmission) * (1.0 - max3(r.dielectric));
  terms.exponent = 2.0 / (alpha * alpha) - 2.0;
  terms.specular = r.at_normal * (terms.exponent + 2.0) / (8.0 * std::numbers::pi);
  terms.mirror_normal = r.at_normal * mirrored;
  terms.mirror_grazing = glm::dvec3(r.at_grazing * mirrored);
  terms.ambient = terms.diffuse + r.at_normal * (1.0 - mirrored);
  terms.transmission = not_metal * r.transmission;
  terms.withheld_normal = max3(r.dielectric);
  terms.withheld_grazing = r.strength;
}

void set_metallic_roughness(SurfaceTerms& terms, const Material& material, const Lookup& lookup) {
  const glm::dvec3 surface = lookup.rgb(TEXTURE_SLOT_SURFACE);
  const double metallic = material.metallic * surface.z;
  const double strength = material.specular_strength * lookup.rgba(TEXTURE_SLOT_SPECULAR).w;
  const glm::dvec3 color = glm::dvec3(material.specular) * lookup.rgb(TEXTURE_SLOT_SPECULAR_COLOR);
  const glm::dvec3 dielectric = glm::min(reflectance_at_normal(material.ior) * color, glm::dvec3(1.0)) * strength;
  const double transmission = material.transmission.x * lookup.rgba(TEXTURE_SLOT_TRANSMISSION).x;
  set_reflectance(terms, {glm::mix(dielectric, terms.base, metallic), glm::mix(strength, 1.0, metallic), dielectric,
                          strength, material.roughness * surface.y, metallic, transmission});
}

void set_specular_glossiness(SurfaceTerms& terms, const Material& material, const Lookup& lookup) {
  const glm::dvec4 surface = lookup.rgba(TEXTURE_SLOT_SURFACE);
  const glm::dvec3 at_normal = glm::min(glm::dvec3(material.specular) * glm::dvec3(surface), glm::dvec3(1.0));
  const double roughness = 1.0 - (1.0 - static_cast<double>(material.roughness)) * surface.w;
  set_reflectance(terms, {at_normal, max3(at_normal) > 0.0 ? 1.0 : 0.0, at_normal, 0.0, roughness, 0.0, 0.0});
}

void set_blinn(SurfaceTerms& terms, const Material& material, const Lookup& lookup, const glm::dvec3& color) {
  const glm::dvec3 surface = lookup.rgb(TEXTURE_SLOT_SURFACE);
  terms.diffuse = terms.base;
  terms.specular = glm::dvec3(material.specular) * surface / std::numbers::pi;
  terms.exponent = material.exponent * lookup.rgba(TEXTURE_SLOT_SPECULAR).x;
  terms.cosine = false;
  terms.ambient = glm::dvec3(material.ambient) * lookup.rgb(TEXTURE_SLOT_SPECULAR_COLOR) * color;
  terms.mirror_normal = glm::dvec3(material.reflection) * surface;
  terms.mirror_grazing = material.fresnel_reflection ? glm::dvec3(1.0) : terms.mirror_normal;
  terms.transmission = glm::dvec3(material.transmission);
  terms.plain_mirror = !material.fresnel_reflection;
  if (terms.plain_mirror || terms.transmission == glm::dvec3(0.0)) return;
  terms.withheld_normal = reflectance_at_normal(material.ior);
  terms.withheld_grazing = 1.0;
  terms.mirror_normal = glm::dvec3(terms.withheld_normal);
}

}  // namespace

double passed_share(const SurfaceTerms& terms, double reflectance, double ior) {
  if (reflectance == 1.0) return 0.0;
  const double withheld = std::lerp(terms.withheld_normal, terms.withheld_grazing, grazing_share(reflectance, ior));
  return std::clamp(1.0 - withheld, 0.0, 1.0);
}

SurfaceTerms surface_terms(const Scene& scene, const Triangle& triangle, const glm::dvec3& weights) {
  const Material& material = scene.materials[triangle.material];
  const Lookup lookup{scene, triangle, weights};
  SurfaceTerms terms;
  const glm::dvec3 color(color_at(scene, triangle, weights));
  terms.base = glm::dvec3(material.base_color) * lookup.rgb(TEXTURE_SLOT_BASE_COLOR) * color;
  if (material.unlit) return terms;
  switch (material.workflow) {
    case Workflow::metallic_roughness:
      set_metallic_roughness(terms, material, lookup);
      break;
    case Workflow::specular_glossiness:
      set_specular_glossiness(terms, material, lookup);
      break;
    case Workflow::blinn:
      set_blinn(terms, material, lookup, color);
      break;
  }
  const double occlusion = lookup.rgba(TEXTURE_SLOT_OCCLUSION).x;
  terms.ambient *= 1.0 + material.occlusion_strength * (occlusion - 1.0);
  terms.emission = glm::dvec3(material.emission) * lookup.rgb(TEXTURE_SLOT_EMISSION);
  return terms;
}

}  // namespace vernier::reference
