#include "scene/gltf_materials.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scene/gltf_texture_use.h"
#include "scene/gltf_values.h"

namespace vernier {
namespace {

/// The number of a 0 in attenuationColor: ln 0 has none. 2^-20 lets less through within one attenuation distance than
/// any display shows.
constexpr double kLeastAttenuation = 0x1p-20;

/// Stands for "infinite", which KHR_materials_ior writes as 0: Fresnel reflectance 1 at every angle, within 4e-6.
constexpr float kInfiniteIor = 1e6f;

struct MaterialSource {
  GltfDocument& document;
  const tinygltf::Material& material;
  std::string place;
  GltfTextures& textures;
  Scene& scene;
};

void set_texture(MaterialSource& source, Material& material, int slot, const GltfTextureReference& reference,
                 TexelEncoding encoding) {
  material.textures[static_cast<std::size_t>(slot)] =
      gltf_texture_use(source.document, reference, encoding, source.place, source.textures, source.scene);
}

glm::vec3 unit_vector3(const glm::dvec3& color) {
  return {gltf_unit_float(color.x), gltf_unit_float(color.y), gltf_unit_float(color.z)};
}

glm::vec3 not_negative(const glm::dvec3& color) {
  return {gltf_float(std::max(color.x, 0.0)), gltf_float(std::max(color.y, 0.0)), gltf_float(std::max(color.z, 0.0))};
}

void read_core(MaterialSource& source, Material& material) {
  const tinygltf::PbrMetallicRoughness& pbr = source.material.pbrMetallicRoughness;
  for (std::size_t c = 0; c < std::min<std::size_t>(pbr.baseColorFactor.size(), 4); ++c) {
    material.base_color[static_cast<int>(c)] = gltf_unit_float(pbr.baseColorFactor[c]);
  }
  material.metallic = gltf_unit_float(pbr.metallicFactor);
  material.roughness = gltf_unit_float(pbr.roughnessFactor);
  set_texture(source, material, TEXTURE_SLOT_BASE_COLOR, texture_reference(pbr.baseColorTexture), TexelEncoding::srgb);
  set_texture(source, material, TEXTURE_SLOT_SURFACE, texture_reference(pbr.metallicRoughnessTexture),
              TexelEncoding::linear);
}

void read_alpha(MaterialSource& source, Material& material) {
  const std::string& mode = source.material.alphaMode;
  if (mode == "MASK") {
    material.alpha_mode = AlphaMode::mask;
  } else if (mode == "BLEND") {
    material.alpha_mode = AlphaMode::blend;
  } else if (mode != "OPAQUE") {
    refuse_gltf(source.document, source.place, "alphaMode " + mode + " does not exist");
  }
  material.alpha_cutoff = gltf_float(source.material.alphaCutoff);
}

void read_surroundings(MaterialSource& source, Material& material) {
  const tinygltf::Material& file = source.material;
  material.double_sided = file.doubleSided;
  material.normal_scale = gltf_float(file.normalTexture.scale);
  material.occlusion_strength = gltf_unit_float(file.occlusionTexture.strength);
  double strength = 1.0;
  if (const auto* value = find_gltf_extension(file.extensions, "KHR_materials_emissive_strength")) {
    strength = gltf_number(*value, "emissiveStrength", 1.0);
  }
  const std::vector<double>& emission = file.emissiveFactor;
  if (emission.size() >= 3) {
    material.emission = not_negative(strength * glm::dvec3(emission[0], emission[1], emission[2]));
  }
  set_texture(source, material, TEXTURE_SLOT_NORMAL, texture_reference(file.normalTexture), TexelEncoding::linear);
  set_texture(source, material, TEXTURE_SLOT_OCCLUSION, texture_reference(file.occlusionTexture),
              TexelEncoding::linear);
  set_texture(source, material, TEXTURE_SLOT_EMISSION, texture_reference(file.emissiveTexture), TexelEncoding::srgb);
}

void read_ior(MaterialSource& source, const tinygltf::Value& value, Material& material) {
  const double ior = gltf_number(value, "ior", 1.5);
  if (ior == 0.0) {
    material.ior = kInfiniteIor;
  } else if (ior >= 1.0) {
    material.ior = gltf_float(ior);
  } else {
    warn_gltf(source.document, source.place, "ior " + std::to_string(ior) + " is below 1: 1.5 is used");
  }
}

void read_volume(MaterialSource& source, const tinygltf::Value& value, Material& material) {
  material.thin_walled = !(gltf_number(value, "thicknessFactor", 0.0) > 0.0);
  const double distance = gltf_number(value, "attenuationDistance", std::numeric_limits<double>::infinity());
  if (!(distance > 0.0)) {
    warn_gltf(source.document, source.place, "attenuationDistance must be above 0: nothing is absorbed");
    return;
  }
  const glm::dvec3 color = gltf_vector3(value, "attenuationColor", glm::dvec3(1.0));
  for (int c = 0; c < 3; ++c) {
    material.absorption[c] = gltf_float(-std::log(std::clamp(color[c], kLeastAttenuation, 1.0)) / distance);
  }
}

void read_specular(MaterialSource& source, const tinygltf::Value& value, Material& material) {
  material.specular_strength = gltf_unit_float(gltf_number(value, "specularFactor", 1.0));
  material.specular = not_negative(gltf_vector3(value, "specularColorFactor", glm::dvec3(1.0)));
  set_texture(source, material, TEXTURE_SLOT_SPECULAR, texture_reference(value, "specularTexture"),
              TexelEncoding::linear);
  set_texture(source, material, TEXTURE_SLOT_SPECULAR_COLOR, texture_reference(value, "specularColorTexture"),
              TexelEncoding::srgb);
}

void read_transmission(MaterialSource& source, const tinygltf::Value& value, Material& material) {
  material.transmission = glm::vec3(gltf_unit_float(gltf_number(value, "transmissionFactor", 0.0)));
  set_texture(source, material, TEXTURE_SLOT_TRANSMISSION, texture_reference(value, "transmissionTexture"),
              TexelEncoding::linear);
}

void read_specular_glossiness(MaterialSource& source, const tinygltf::Value& value, Material& material) {
  material.workflow = Workflow::specular_glossiness;
  material.metallic = 0.0f;
  material.base_color = glm::vec4(1.0f);
  if (value.Has("diffuseFactor") && value.Get("diffuseFactor").ArrayLen() == 4) {
    for (int c = 0; c < 4; ++c) {
      const tinygltf::Value& component = value.Get("diffuseFactor").Get(c);
      if (component.IsNumber()) material.base_color[c] = gltf_unit_float(component.GetNumberAsDouble());
    }
  }
  material.specular = unit_vector3(gltf_vector3(value, "specularFactor", glm::dvec3(1.0)));
  material.roughness = 1.0f - gltf_unit_float(gltf_number(value, "glossinessFactor", 1.0));
  set_texture(source, material, TEXTURE_SLOT_BASE_COLOR, texture_reference(value, "diffuseTexture"),
              TexelEncoding::srgb);
  set_texture(source, material, TEXTURE_SLOT_SURFACE, texture_reference(value, "specularGlossinessTexture"),
              TexelEncoding::srgb);
}

void read_metallic_extensions(MaterialSource& source, Material& material) {
  const tinygltf::ExtensionMap& extensions = source.material.extensions;
  if (const auto* ior = find_gltf_extension(extensions, "KHR_materials_ior")) read_ior(source, *ior, material);
  if (const auto* volume = find_gltf_extension(extensions, "KHR_materials_volume"))
    read_volume(source, *volume, material);
  if (const auto* specular = find_gltf_extension(extensions, "KHR_materials_specular")) {
    read_specular(source, *specular, material);
  }
  if (const auto* transmission = find_gltf_extension(extensions, "KHR_materials_transmission")) {
    read_transmission(source, *transmission, material);
  }
}

}  // namespace

Material gltf_default_material() {
  Material material;
  material.name = "default";
  material.metallic = 1.0f;
  return material;
}

Material gltf_material(GltfDocument& document, int index, GltfTextures& textures, Scene& scene) {
  const tinygltf::Material& file = document.model.materials[static_cast<std::size_t>(index)];
  MaterialSource source{document, file, "material " + std::to_string(index), textures, scene};
  Material material;
  material.name = file.name;
  material.unlit = file.extensions.contains("KHR_materials_unlit");
  const auto* glossiness = find_gltf_extension(file.extensions, "KHR_materials_pbrSpecularGlossiness");
  if (glossiness != nullptr) {
    read_specular_glossiness(source, *glossiness, material);
  } else {
    read_core(source, material);
    read_metallic_extensions(source, material);
  }
  read_alpha(source, material);
  read_surroundings(source, material);
  return material;
}

}  // namespace vernier
