#pragma once

#include <string>

#include "image/image.h"

namespace vernier {

/// A hint that suggests an --exposure when more than half the pixels of the colour layer of `image` are brighter than 1
/// after `exposure_ev`, else an empty text. A pixel's brightness is its largest channel; the suggestion, rounded down
/// to half stops, brings the median to 1 at most.
std::string exposure_hint(const ImageFile& image, float exposure_ev);

}  // namespace vernier
