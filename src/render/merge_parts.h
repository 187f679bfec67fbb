#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "image/image.h"

namespace vernier {

/// Samples [sample_begin, sample_end) of the pixels that `image` holds of its full image.
struct ImagePart {
  std::string name;  ///< for errors: the file
  ImageFile image;
  std::uint32_t sample_begin = 0;
  std::uint32_t sample_end = 0;
};

/// The image of `spp` samples whose parts these are: the bits of a render that was never cut. Pixels of parts with all
/// samples are taken as they are; those of others, which have the layer `film`, are summed up and developed. `aovs`:
/// the layers beside the colours, in their order. Metadata are left empty.
/// Throws Error(refused) that names the part, for one of another size, a layer that is missing or of another shape,
/// samples that two parts hold or that none does, and a film that does not hold the samples its part claims.
ImageFile merge_parts(const std::vector<ImagePart>& parts, std::uint32_t spp, const std::vector<std::string>& aovs);

}  // namespace vernier
