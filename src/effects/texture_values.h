#pragma once

#include <array>
#include <vector>

#include "scene/scene.h"

namespace vernier {

/// What the texels of a texture have in common, per channel r g b a.
struct TextureValues {
  std::array<bool, 4> zero = {};  ///< all exactly 0
  std::array<bool, 4> one = {};   ///< all exactly 1: no look-up between them is anything else
};

/// The values of every texture of `scene`, by index; of those alone that `wanted` (by index) marks. Neither zero nor
/// one where a texture was not wanted or has no texels. O(texels), and a few texels of those that vary.
std::vector<TextureValues> texture_values(const Scene& scene, const std::vector<bool>& wanted);

}  // namespace vernier
