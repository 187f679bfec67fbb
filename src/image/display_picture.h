#pragma once

#include "image/image.h"

namespace vernier {

/// How linear colour becomes a display image.
struct DisplayTransform {
  float exposure_ev = 0.0f;  ///< multiplies the colour layer by 2^exposure_ev; within +-100
};

/// What the values of a layer are, as far as its display depends on it.
enum class LayerMeaning { color, depth, direction, position, uv, id, cost, amount };

/// Meaning by the names that the command line promises: channels R G B: color; Z alone: depth; X Y Z: direction where
/// the layer's name ends in `normal`, else position; U V: uv; ID: id; rays nodes triangles: cost; anything else:
/// amount.
LayerMeaning layer_meaning(const Layer& layer);

/// `layer` of `width` x `height` pixels as display code values: [height][width][3] in [0, 1], times 255 a byte.
/// color: sRGB curve of the clamped value (times 2^exposure_ev in the layer without a name), alpha dropped since the
/// background is part of the picture. depth: nearest 1 to farthest 0.1, +infinity (a miss) black. direction: n/2 + 1/2.
/// position: each axis from its smallest to its largest finite value. uv: fractions in red and green. id: a colour
/// hashed from the number, 4294967295 (a miss) black. cost: a heat map (cost_picture). amount: up to three channels as
/// red, green and blue, one as grey, each divided by its largest finite value, below 0 black. A pixel with any other
/// non-finite value is magenta. `layer.values` must hold width x height x channels values.
Image display_picture(const Layer& layer, int width, int height, const DisplayTransform& display);

/// `layer` as non-negative finite numbers for a format without sign and infinity: [height][width][3]. color, depth,
/// cost and amount keep their values with negative ones and misses 0, the rest is as in display_picture. A pixel with
/// any other non-finite value is magenta, (1, 0, 1).
Image unsigned_picture(const Layer& layer, int width, int height);

}  // namespace vernier
