#pragma once

#include <cstddef>
#include <glm/glm.hpp>

#include "scene/scene.h"

namespace vernier {

/// Texel `index` (row * width + column) of `texels` as linear rgba, whatever its format. Exact for
/// TEXTURE_FORMAT_FLOAT. `index` is below width * height; the words fit format and size.
glm::vec4 texel_color(const Texels& texels, std::size_t index);

}  // namespace vernier
