#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace vernier {

/// OpenImageIO's name for the format of the image `encoded` (`png`, `jpg`, `webp`, `bmp`, `hdr`, `exr`, `tif`, `gif`,
/// `dds`, `tga`, `jp2` or `ppm`): by its first bytes, or for formats without a signature by the extension of `name`.
/// Formats whose readers end the process on a damaged file, or read another one, are left out. Throws Error(refused)
/// for those, and for headers that the reader of their format does not look through.
std::string encoded_format(std::span<const std::byte> encoded, const std::string& name);

}  // namespace vernier
