#include "render/pack_materials.h"

#include <bit>
#include <cstring>
#include <map>
#include <unordered_set>

#include "effects/effective_material.h"
#include "error.h"
#include "image/srgb_curve.h"
#include "render/append_words.h"
#include "shared/render_constants.h"

namespace vernier {
namespace {

/// Texels of a texture begin at multiples of 4 words.
std::size_t whole_quads(std::size_t words) {
  return (words + 3) / 4 * 4;
}

DeviceTextureUse device_texture_use(const TextureUse& use) {
  const glm::mat3x2& m = use.uv_from_vertex_uv;
  return {.texture = use.texture < 0 ? NONE : static_cast<std::uint32_t>(use.texture),
          .uv_set = use.uv_set,
          .m00 = m[0][0],
          .m10 = m[0][1],
          .m01 = m[1][0],
          .m11 = m[1][1],
          .m02 = m[2][0],
          .m12 = m[2][1]};
}

std::uint32_t material_flags(const Material& material) {
  std::uint32_t flags = static_cast<std::uint32_t>(material.workflow) | static_cast<std::uint32_t>(material.alpha_mode)
                                                                            << MATERIAL_ALPHA_SHIFT;
  if (material.unlit) flags |= MATERIAL_UNLIT;
  if (material.thin_walled) flags |= MATERIAL_THIN_WALLED;
  if (material.fresnel_reflection) flags |= MATERIAL_FRESNEL_REFLECTION;
  return flags;
}

}  // namespace

DeviceMaterial device_material(const Material& material, double metres_per_unit) {
  DeviceMaterial device{};
  device.base_color = material.base_color;
  device.specular = material.specular;
  device.roughness = material.workflow == Workflow::blinn ? material.exponent : material.roughness;
  device.reflection = material.reflection;
  device.metallic = material.metallic;
  device.emission = material.emission;
  device.ior = material.ior;
  device.transmission = material.unlit ? glm::vec3(0.0f) : material.transmission;
  device.alpha_cutoff = material.alpha_cutoff;
  device.absorption = glm::vec3(glm::dvec3(material.absorption) * metres_per_unit);
  device.normal_scale = material.normal_scale;
  device.ambient = material.ambient;
  device.occlusion_strength = material.occlusion_strength;
  device.flags = material_flags(material);
  device.specular_strength = material.specular_strength;
  for (std::uint32_t slot = 0; slot < TEXTURE_SLOT_COUNT; ++slot) {
    if (material.textures[slot].texture >= 0) device.textured_slots |= 1u << slot;
  }
  return device;
}

std::vector<std::uint32_t> pack_materials(const Scene& scene, double metres_per_unit) {
  const std::vector<TextureValues> values = texture_values(scene, std::vector<bool>(scene.textures.size(), true));
  std::vector<std::uint32_t> words;
  words.reserve(scene.materials.size() * MATERIAL_TEXELS * 4);
  for (const Material& material : scene.materials) {
    append_words(words, device_material(with_zero_factors(material, values), metres_per_unit));
    for (const TextureUse& use : material.textures) append_words(words, device_texture_use(use));
  }
  return words;
}

std::uint64_t texel_words(const Scene& scene) {
  std::unordered_set<const Texels*> counted;
  std::uint64_t words = 0;
  for (const Texture& texture : scene.textures) {
    if (counted.insert(texture.texels.get()).second) words += whole_quads(texture.texels->words.size());
  }
  return words;
}

PackedTextures pack_textures(const Scene& scene) {
  PackedTextures packed;
  packed.texels.reserve(SRGB_CURVE_WORDS + texel_words(scene));
  for (int byte = 0; byte < static_cast<int>(SRGB_CURVE_WORDS); ++byte) {
    packed.texels.push_back(std::bit_cast<std::uint32_t>(static_cast<float>(linear_from_srgb(byte / 255.0))));
  }
  std::map<const Texels*, std::size_t> first_word;
  for (const Texture& texture : scene.textures) {
    const Texels& texels = *texture.texels;
    const auto [entry, is_new] = first_word.try_emplace(&texels, packed.texels.size());
    if (is_new) {
      packed.texels.insert(packed.texels.end(), texels.words.begin(), texels.words.end());
      packed.texels.resize(whole_quads(packed.texels.size()));
    }
    if (packed.texels.size() >= NONE) {
      throw Error(ErrorKind::refused, scene.source + ": textures need more than 4294967294 words");
    }
    const Sampler& sampler = texture.sampler;
    packed.textures.insert(
        packed.textures.end(),
        {texels.width, texels.height, static_cast<std::uint32_t>(entry->second),
         texels.format | sampler.wrap_u << TEXTURE_WRAP_U_SHIFT | sampler.wrap_v << TEXTURE_WRAP_V_SHIFT |
             sampler.filter << TEXTURE_FILTER_SHIFT | sampler.filter << TEXTURE_FILE_FILTER_SHIFT});
  }
  return packed;
}

}  // namespace vernier
