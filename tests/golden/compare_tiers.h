#pragma once

#include <string>

#include "golden_case.h"
#include "image/image.h"

namespace vernier::golden {

/// What a tier found: `faults` is empty when it passes, else one line that names figures and the first pixel.
struct TierResult {
  std::string faults;
  std::string figures;  ///< what was measured, for the log
};

/// Tier A: object and primitive of every pixel centre, and the count of samples that hit anything, equal the golden's,
/// except in pixels that are undecided.
TierResult compare_hits(const ImageFile& render, const ImageFile& golden, const HitBounds& bounds, std::uint32_t spp);

/// Tier B: linear colour. Undecided pixels are not compared one by one, but count in the RMSE.
TierResult compare_linear(const ImageFile& render, const ImageFile& golden, const LinearBounds& bounds,
                          double rounding_steps);

/// Tier C: `shown` is the render as its PNG holds it; the golden is not rounded to 8 bits.
TierResult compare_display(const Image& shown, const ImageFile& golden, const DisplayBounds& bounds);

/// The layer `name` of `image`. Throws Error(refused) where it is missing.
const Layer& layer_of(const ImageFile& image, const std::string& name);

/// The colour layer as an image of four channels.
Image color_of(const ImageFile& image);

}  // namespace vernier::golden
