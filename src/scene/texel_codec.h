#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>

#include "scene/texture_from_image.h"

namespace vernier {

extern "C" {

/// decode_texels, of an image in the format `format` (encoded_format); of PNG what essential_png leaves.
/// Calls claim(bytes) before the memory for the texels is taken. A function of the module of codecs, called through
/// `codec` (image/codec_module.h) alone.
[[gnu::visibility("default")]] void read_texels(std::span<const std::byte> encoded, const std::string& format,
                                                const std::string& name, TexelEncoding encoding,
                                                const std::function<void(std::uint64_t)>& claim, Texels& texels);

}  // extern "C"

}  // namespace vernier
