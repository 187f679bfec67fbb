#pragma once

#include <glm/glm.hpp>

#include "scene/scene.h"

namespace vernier::reference {

/// Texel (x, y) of `texels`, decoded to linear RGBA. x and y are within the image.
glm::dvec4 texel(const Texels& texels, int x, int y);

/// `texels` at `uv`, v downwards, (0, 0) the corner of the first texel, filtered and wrapped as `sampler` says: "Image
/// formation" section 3, Textures. A non-finite uv reads texel (0, 0).
glm::dvec4 sample_texels(const Texels& texels, const Sampler& sampler, glm::dvec2 uv);

}  // namespace vernier::reference
