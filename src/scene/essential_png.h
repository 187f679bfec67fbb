#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "scene/png_chunks.h"

namespace vernier {

/// A PNG file of nothing but `chunks`, and IEND where it is missing, for libpng: that prints lines of its own on stderr
/// about colour profiles and other chunks that exporters write badly, and about damage; so the former are left out and
/// the latter is looked for first, in the compressed pixels too (png_pixels.h), which are inflated once more for that;
/// those of more than kMaxTexels are not. Throws Error(refused) "`name`: ..." for pixels that are damaged.
std::vector<std::byte> essential_png(const PngChunks& chunks, const std::string& name);

}  // namespace vernier
