#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scene/png_chunks.h"

namespace vernier {

/// Whether plain_png_words reads such a file: 8 bits a channel, not interlaced, transparency only in a palette. Nearly
/// all textures are.
bool is_plain_png(const PngChunks& chunks);

/// The texels of a plain PNG as red, green, blue and alpha from the lowest byte of a word up, row 0 first: grey three
/// times, alpha 255 where there is none, palette entries that are not there black. Inflates the pixels once and checks
/// them on the way. Throws Error(refused) "`name`: ..." for pixels that are damaged.
std::vector<std::uint32_t> plain_png_words(const PngChunks& chunks, const std::string& name);

}  // namespace vernier
