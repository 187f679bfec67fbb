#pragma once

#include <string>

#include "error.h"

namespace vernier {

/// The image formats that are read and written.
enum class FileFormat { exr, png, jpeg, hdr, tiff };

/// Longest side of an image that the format JPEG is written for, that of libjpeg.
inline constexpr int kMostJpegSide_px = 65500;

/// The extension of `path` with its dot, in small letters; empty where there is none.
std::string lower_case_extension(const std::string& path);

/// Format that the extension of `path` names: .exr, .png, .jpg or .jpeg, .hdr, .tif or .tiff, in any case of letters.
/// Throws Error(`kind_if_unknown`) with the list of extensions for every other one and for none.
FileFormat file_format(const std::string& path, ErrorKind kind_if_unknown);

}  // namespace vernier
