#pragma once

#include <cstdint>
#include <vector>

#include "scene/scene.h"
#include "shared/material_layout.h"

namespace vernier {

/// `material` in device layout; absorption per unit of the traced space.
DeviceMaterial device_material(const Material& material, double metres_per_unit);

/// All materials: [material][MATERIAL_TEXELS][4] words, each a DeviceMaterial and its DeviceTextureUses.
std::vector<std::uint32_t> pack_materials(const Scene& scene, double metres_per_unit);

/// Words that pack_textures makes of the texels of all textures, shared ones once.
std::uint64_t texel_words(const Scene& scene);

/// Textures and their texels.
struct PackedTextures {
  std::vector<std::uint32_t> textures;  ///< [texture][4]: width, height, first word of texels, format, wraps and filter
  std::vector<std::uint32_t> texels;    ///< as BINDING_TEXELS has them, shared ones once
};

/// Packs all textures. Throws Error(refused) when the texels need 2^32 words or more.
PackedTextures pack_textures(const Scene& scene);

}  // namespace vernier
