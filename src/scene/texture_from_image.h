#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>

#include "scene/scene.h"

namespace vernier {

/// What the colour channels of an image mean. Alpha is always linear.
enum class TexelEncoding {
  srgb,      ///< colours of a surface: integers through the sRGB curve, what is stored times alpha divided by it
  radiance,  ///< of surroundings: the same, but as they are stored
  linear     ///< data (normals, factors): value / 255
};

/// Longest side of an image that is decoded, and most texels of it: what a hostile header may make us allocate
/// (4 GiB as float) is settled before anything is allocated.
inline constexpr int kMaxTextureSide_px = 32768;
inline constexpr std::uint64_t kMaxTexels = std::uint64_t{1} << 28;

/// Decodes an image file in memory, in a format that encoded_format knows. Row 0 is the top row. One and two channels
/// become grey and grey-alpha; missing alpha is 1; alpha is not premultiplied. 8-bit images get TEXTURE_FORMAT_SRGB8 or
/// TEXTURE_FORMAT_LINEAR8 as `encoding` says; deeper ones TEXTURE_FORMAT_FLOAT in linear light (integer colours of
/// encoding srgb are decoded). Only the first subimage is read. NaN and infinity in float images become 0. Throws
/// Error(refused) "`name`: what is wrong" for an empty, broken, unknown or too large image, MemoryError where the host
/// has too little memory for its texels, and what codec_address does.
std::shared_ptr<const Texels> decode_texels(std::span<const std::byte> encoded, const std::string& name,
                                            TexelEncoding encoding);

/// The same from the file at `path`. Throws Error(refused) with `path` also where it cannot be read.
std::shared_ptr<const Texels> decode_texels_from_file(const std::string& path, TexelEncoding encoding);

/// Throws Error(refused) with `path`, as decode_texels_from_file, where no regular file is there.
void check_image_file(const std::string& path);

}  // namespace vernier
