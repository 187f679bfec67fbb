#pragma once

#include <vector>

#include "image/image.h"

namespace vernier {

/// Viewing distance that FLIP was published with: 0.7 m from a 0.7 m wide monitor of 3840 pixels.
inline constexpr double kFlipPixelsPerDegree = 67.0;

/// How visible a difference is when two images are shown in turn on the same screen.
struct FlipError {
  int width = 0;
  int height = 0;
  std::vector<float> map;  ///< [height][width] in [0, 1]: 0 the same, 1 green against blue
  double mean = 0.0;
  double p99 = 0.0;  ///< smallest value of the map that at least 99 % of the pixels do not exceed
};

/// LDR-FLIP of `test` against `reference`, from the definitions in Andersson, Nilsson, Akenine-Moeller, Oskarsson,
/// Astroem and Fairchild 2020, FLIP: A Difference Evaluator for Alternating Images, PACM CGIT 3(2).
/// Both are linear Rec.709, multiplied by 2^exposure_ev and clamped to [0, 1]; non-finite pixels count as magenta, as a
/// display image shows them. No rounding to 8 bits takes place. `pixels_per_degree` (1 to 10000) is the
/// viewing distance, `exposure_ev` within +-100. Alpha is not compared. Single precision, one thread; O(pixels x
/// pixels_per_degree). Throws Error(usage) as compare_images does and for values of the parameters outside their range.
FlipError flip(const Image& reference, const Image& test, float exposure_ev = 0.0f,
               double pixels_per_degree = kFlipPixelsPerDegree);

}  // namespace vernier
