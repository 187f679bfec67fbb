#pragma once

#include <span>

#include "effects/texture_values.h"
#include "scene/material.h"

namespace vernier {

/// `material` as its textures leave it: where all texels of a slot are 0 in what the slot reads, the factor is 0; where
/// they are all 1, the texture is gone; and an alpha mode that no texel and no vertex colour can call for is opaque.
/// Every term of shaders/README.md, section 4, has the same bits as the material's own. `values` by texture
/// (texture_values).
Material effective_material(const Material& material, std::span<const TextureValues> values, bool vertex_colors);

}  // namespace vernier
