#pragma once

#include <string>

#include "scene/pending_images.h"
#include "scene/scene.h"

namespace vernier {

/// Has an equirectangular image (HDR, EXR, or any other; 8-bit ones through the sRGB curve) decoded as the environment:
/// a TEXTURE_FORMAT_FLOAT texture, repeated in u, clamped in v, linear. Returns its index in scene.textures.
/// Direction d meets u = 1/2 + atan2(d.x, -d.z) / (2 pi), v = acos(d.y) / pi: -Z in the middle, +X to its right, row 0
/// up. Throws Error(refused) with `path` for a missing image, images.finish for a broken one.
int add_environment_image(Scene& scene, PendingImages& images, const std::string& path);

}  // namespace vernier
