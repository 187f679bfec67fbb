#pragma once

#include "scene/scene.h"

namespace vernier {

/// One channel of `texels` in r, g and b of a LINEAR8 (from 8 bits) or FLOAT image of the same size, alpha 1.
/// `channel` as in MTL -imfchan: r g b, m or z for alpha, l for the mean of r, g, b. '\0' is alpha where any texel has
/// one below 1, else l: files made for map_d keep their mask in either. The values are taken as stored, without the
/// sRGB curve.
Texels scalar_map(const Texels& texels, char channel);

/// Tangent-space normal map (rgb = (n + 1) / 2, FLOAT, because 8 bits cannot hold shallow slopes) of a height map:
/// n = unit(-strength dh/du, -strength dh/dv', 1), v' upwards, by central differences per texel (h from 0 to 1 over one
/// texel at strength 1 is a slope of 1/2), so a doubled resolution needs a doubled strength, as everywhere where MTL's
/// unitless -bm is used. Neighbours beyond the border by TEXTURE_WRAP_* `wrap` (repeat, else clamped).
/// `heights` is r of a scalar_map. Strength 0 gives (0, 0, 1) everywhere.
Texels normals_from_heights(const Texels& heights, double strength, std::uint32_t wrap);

}  // namespace vernier
