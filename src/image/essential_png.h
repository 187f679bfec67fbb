#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace vernier {

/// The first bytes of every PNG file.
inline constexpr std::string_view kPngSignature = "\x89PNG\r\n\x1a\n";

/// What becomes of a PNG's texts (tEXt), among them what write_image says of a picture.
enum class PngText { dropped, kept };

/// The PNG file `encoded` with nothing but what its pixels need: IHDR, PLTE, tRNS, IDAT and IEND (added where it is
/// missing). libpng prints lines of its own on stderr about colour profiles and other chunks that exporters write
/// badly, and about damage; so the former are left out and the latter is looked for first: lengths, checksums, order,
/// header and the compressed pixels (png_pixels.h), which are inflated once more for that; those of more than
/// `most_pixels` are not, since the reader refuses them by their size. `encoded` begins with kPngSignature. Throws
/// Error(refused) "`name`: ..." for a file that is damaged. W3C, PNG Specification, Third Edition.
std::vector<std::byte> essential_png(std::span<const std::byte> encoded, const std::string& name,
                                     std::uint64_t most_pixels, PngText text = PngText::dropped);

}  // namespace vernier
