#pragma once

#include <span>

#include "effects/texture_values.h"
#include "scene/material.h"

namespace vernier {

/// `material` with a factor of 0 for each slot whose texels are all 0 in what the slot reads. What the device is told:
/// it does not look a texture up that leaves nothing. `values` by texture (texture_values).
Material with_zero_factors(Material material, std::span<const TextureValues> values);

/// `material` as its textures leave it: with zero factors; where all texels are 1, the texture is gone; and an alpha
/// mode that no texel and no vertex colour can call for is opaque. Every term of shaders/README.md, section 4, has the
/// same bits as the material's own. `values` by texture (texture_values).
Material effective_material(const Material& material, std::span<const TextureValues> values, bool vertex_colors);

}  // namespace vernier
