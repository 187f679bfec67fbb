#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "scene/texture_from_image.h"

namespace vernier {

extern "C" {

/// decode_texels, of an image in the format that `extension` (without dot) names; of PNG what essential_png leaves.
/// A function of the module of codecs, called through `codec` (image/codec_module.h) alone.
[[gnu::visibility("default")]] void read_texels(std::span<const std::byte> encoded, const std::string& extension,
                                                const std::string& name, TexelEncoding encoding, Texels& texels);

}  // extern "C"

}  // namespace vernier
