#pragma once

#include "scene/scene.h"

namespace vernier {

/// What a normal texture does to normals.
enum class NormalMapBend {
  none,   ///< no look-up, between texels neither, changes a normal by a bit
  alike,  ///< all texels are the same, but not flat: bytes have no 1/2, so one made flat with them bends a little
  varies
};

/// What `texels` do as a normal texture of factor `scale`. Stops at the first texel that is neither flat nor like the
/// one before it.
NormalMapBend normal_map_bend(const Texels& texels, float scale);

}  // namespace vernier
