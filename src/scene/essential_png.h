#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace vernier {

/// The PNG file `encoded` with nothing but what its pixels need: IHDR, PLTE, tRNS, IDAT and IEND (added where it is
/// missing). libpng prints lines of its own on stderr about colour profiles and other chunks that exporters write
/// badly, and about damage; so the former are left out and the latter is looked for first: lengths, checksums, order,
/// header and the compressed pixels (png_pixels.h), which are inflated once more for that; those of more than
/// kMaxTexels are not. `encoded` begins with a PNG signature. Throws Error(refused) "`name`: ..." for a file that is
/// damaged. W3C, PNG Specification, Third Edition.
std::vector<std::byte> essential_png(std::span<const std::byte> encoded, const std::string& name);

}  // namespace vernier
