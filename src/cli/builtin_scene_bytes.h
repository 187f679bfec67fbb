#pragma once

#include <cstddef>
#include <span>

namespace vernier {

/// The bytes of scenes/every_effect.glb; the build writes the definition.
extern const std::span<const std::byte> kBuiltinSceneBytes;

}  // namespace vernier
