#include "effects/effective_material.h"

#include <initializer_list>

namespace vernier {
namespace {

enum Channel : std::size_t { kRed, kGreen, kBlue, kAlpha };

/// What the texels of one slot of a material have in common; nothing where it has no texture.
class Slot {
 public:
  Slot(Material& material, int slot, std::span<const TextureValues> values) : use_(material.textures[slot]) {
    if (use_.texture >= 0) values_ = values[static_cast<std::size_t>(use_.texture)];
  }

  bool zero(std::initializer_list<Channel> channels) const { return all(values_.zero, channels); }
  bool one(std::initializer_list<Channel> channels) const { return all(values_.one, channels); }
  void remove() { use_.texture = -1; }

 private:
  static bool all(const std::array<bool, 4>& values, std::initializer_list<Channel> channels) {
    for (const Channel channel : channels) {
      if (!values[channel]) return false;
    }
    return true;
  }

  TextureUse& use_;
  TextureValues values_;
};

void apply_alpha(Material& material, std::span<const TextureValues> values, bool vertex_colors) {
  const bool blinn = material.workflow == Workflow::blinn;
  Slot slot(material, blinn ? TEXTURE_SLOT_ALPHA : TEXTURE_SLOT_BASE_COLOR, values);
  const float least = material.alpha_mode == AlphaMode::mask ? material.alpha_cutoff : 1.0f;
  if (slot.one({blinn ? kRed : kAlpha}) && !vertex_colors && material.base_color.w >= least) {
    material.alpha_mode = AlphaMode::opaque;
  }
  if (blinn && slot.one({kRed})) slot.remove();
}

void apply_base_color(Material& material, std::span<const TextureValues> values) {
  Slot slot(material, TEXTURE_SLOT_BASE_COLOR, values);
  const bool alpha_counts = material.workflow != Workflow::blinn && material.alpha_mode != AlphaMode::opaque;
  const bool alone = slot.zero({kRed, kGreen, kBlue}) || slot.one({kRed, kGreen, kBlue});
  if (alone && (!alpha_counts || slot.one({kAlpha}))) slot.remove();
}

void apply_surface(Material& material, std::span<const TextureValues> values) {
  Slot slot(material, TEXTURE_SLOT_SURFACE, values);
  if (material.workflow == Workflow::metallic_roughness) {
    const bool rough_alone = slot.one({kGreen}) || material.roughness == 0.0f;
    const bool metal_alone = slot.one({kBlue}) || material.metallic == 0.0f;
    if (rough_alone && metal_alone) slot.remove();
  } else if (slot.one({kRed, kGreen, kBlue, kAlpha})) {
    slot.remove();
  }
}

void apply_light(Material& material, std::span<const TextureValues> values) {
  Slot emission(material, TEXTURE_SLOT_EMISSION, values);
  if (emission.one({kRed, kGreen, kBlue})) emission.remove();
  Slot occlusion(material, TEXTURE_SLOT_OCCLUSION, values);
  if (occlusion.one({kRed})) occlusion.remove();
}

/// KHR_materials_transmission and KHR_materials_specular.
void apply_dielectric(Material& material, std::span<const TextureValues> values) {
  if (material.workflow != Workflow::metallic_roughness) return;
  Slot transmission(material, TEXTURE_SLOT_TRANSMISSION, values);
  if (transmission.one({kRed})) transmission.remove();
  Slot strength(material, TEXTURE_SLOT_SPECULAR, values);
  if (strength.one({kAlpha})) strength.remove();
  Slot color(material, TEXTURE_SLOT_SPECULAR_COLOR, values);
  if (color.one({kRed, kGreen, kBlue})) color.remove();
}

}  // namespace

Material with_zero_factors(Material material, std::span<const TextureValues> values) {
  const auto is_zero = [&](int slot, std::initializer_list<Channel> channels) {
    return Slot(material, slot, values).zero(channels);
  };
  if (is_zero(TEXTURE_SLOT_BASE_COLOR, {kRed, kGreen, kBlue}))
    material.base_color = {0.0f, 0.0f, 0.0f, material.base_color.w};
  if (is_zero(TEXTURE_SLOT_EMISSION, {kRed, kGreen, kBlue})) material.emission = glm::vec3(0.0f);
  if (material.workflow != Workflow::metallic_roughness) return material;
  if (is_zero(TEXTURE_SLOT_SURFACE, {kGreen})) material.roughness = 0.0f;
  if (is_zero(TEXTURE_SLOT_SURFACE, {kBlue})) material.metallic = 0.0f;
  if (is_zero(TEXTURE_SLOT_TRANSMISSION, {kRed})) material.transmission = glm::vec3(0.0f);
  if (is_zero(TEXTURE_SLOT_SPECULAR, {kAlpha})) material.specular_strength = 0.0f;
  if (is_zero(TEXTURE_SLOT_SPECULAR_COLOR, {kRed, kGreen, kBlue})) material.specular = glm::vec3(0.0f);
  return material;
}

Material effective_material(const Material& material, std::span<const TextureValues> values, bool vertex_colors) {
  Material effective = with_zero_factors(material, values);
  apply_alpha(effective, values, vertex_colors);
  apply_base_color(effective, values);
  apply_surface(effective, values);
  apply_light(effective, values);
  apply_dielectric(effective, values);
  return effective;
}

}  // namespace vernier
