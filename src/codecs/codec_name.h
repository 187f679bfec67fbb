#pragma once

#include "image/file_format.h"

namespace vernier {

/// Name by which OpenImageIO creates the reader or writer of `format`.
const char* codec_name(FileFormat format);

}  // namespace vernier
