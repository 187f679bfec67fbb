#include "effects/mirror_weight.h"

#include <algorithm>
#include <limits>

namespace vernier {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::infinity();

double largest(const glm::vec3& value) {
  return std::max({value.x, value.y, value.z});
}

// Texels of bytes are at most 1.
bool has_float_texture(const Scene& scene, const Material& material) {
  return std::ranges::any_of(material.textures, [&](const TextureUse& use) {
    const Texels* texels =
        use.texture < 0 ? nullptr : scene.textures[static_cast<std::size_t>(use.texture)].texels.get();
    return texels != nullptr && texels->format == TEXTURE_FORMAT_FLOAT;
  });
}

bool is_share(float value) {
  return value >= 0.0f && value <= 1.0f;
}

bool in_range(const Material& material) {
  return is_share(material.roughness) && is_share(material.metallic) && is_share(material.specular_strength);
}

// (1 - r)^2 of every roughness that texels can make of the factor.
double largest_gloss(const Material& material) {
  const bool textured = material.textures[TEXTURE_SLOT_SURFACE].texture >= 0;
  const bool polished = textured && material.workflow == Workflow::metallic_roughness;
  const double gloss = 1.0 - (polished ? 0.0 : material.roughness);
  return gloss * gloss;
}

// Of F0 and F90 (shaders/README.md, Image formation 4): mixtures of a dielectric's and a metal's.
double largest_reflectance(const Material& material) {
  if (material.workflow == Workflow::specular_glossiness) return 1.0;
  const double dielectric = material.specular_strength;
  const double metal = material.metallic != 0.0f ? std::max(1.0, largest(material.base_color)) : 0.0;
  return std::max(dielectric, metal);
}

}  // namespace

double largest_mirror_weight(const Scene& scene, const Material& material, const MaterialTerms& terms,
                             const MaterialUsage& usage) {
  if (!terms.mirror) return 0.0;
  if (terms.transmission || usage.vertex_colors || !in_range(material) || has_float_texture(scene, material))
    return kUnknown;
  const double weight = material.workflow == Workflow::blinn
                            ? std::max(largest(material.reflection), material.fresnel_reflection ? 1.0 : 0.0)
                            : largest_reflectance(material) * largest_gloss(material);
  // A dozen roundings of the shader, each 2^-24.
  constexpr double kRoundings = 1.0 + 0x1p-20;
  return weight >= 0.0 ? weight * kRoundings : kUnknown;  // NaN: unknown
}

}  // namespace vernier
