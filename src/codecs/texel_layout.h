#pragma once

#include <OpenImageIO/imageio.h>

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>

namespace vernier {

/// How the pixels of an image file become those of a texture.
struct TexelLayout {
  int first_channel = 0;  ///< of those that are read
  int channel_count = 3;
  std::array<int, 4> channels = {0, 1, 2, -1};  ///< red, green, blue and alpha among them; -1: 0, of alpha opaque
  bool divides_by_alpha = false;                ///< colours are stored times alpha
  bool is_negative = false;                     ///< 0 is white
  int width = 0;                                ///< of the texture: EXR's display window
  int height = 0;
  int left = 0;  ///< where the stored pixels lie in it
  int top = 0;
  bool flips_x = false;
  bool flips_y = false;

  /// Number of the texel at the stored pixel (x, y), or nothing where it lies outside.
  std::optional<std::size_t> texel_of(int x, int y) const;
};

/// By what OpenImageIO tells of the file `encoded` of `format`. Throws Error(refused) with `name` for pixels that are
/// stored column by column, and for few pixels in a huge display window.
TexelLayout texel_layout(const OIIO::ImageSpec& spec, const std::string& format, std::span<const std::byte> encoded,
                         const std::string& name);

}  // namespace vernier
