#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "image/image.h"
#include "render/render_settings.h"
#include "render/render_statistics.h"

namespace vernier {

/// What a film holds, as values.
struct DevelopedFilm {
  std::vector<float> color;  ///< [height][width][4] RGBA: mean of the samples, linear Rec.709; alpha the share of hits.
                             ///< NaN where a sample was not finite; 0 where there is no sample
  std::vector<std::uint32_t> sample_count;  ///< [height][width]
  std::vector<float> cost;                  ///< [height][width][3]: rays, nodes, triangles per sample
  std::uint64_t non_finite_pixels = 0;
  SamplePlace first_non_finite;  ///< where there is one, in pixels of the full image
  std::uint32_t least_samples = 0;
  double mean_samples = 0.0;
};

/// Turns read_sums' words of an area that starts at (area.x, area.y) into values. Sums are exact; the mean is rounded
/// once to double and once to float.
DevelopedFilm develop(const std::vector<std::uint32_t>& sums, const PixelRect& area);

/// Names of the layers that --aov may ask for: those at pixel centres first, then those of the film.
const std::vector<std::string>& aov_names();

/// Whether the layer `aov` is made of the film's sums, and not of what the pixel's centre shows.
bool is_film_aov(std::string_view aov);

/// The layers named in `aovs` from read_aovs' words and the film's costs.
std::vector<Layer> aov_layers(const std::vector<std::string>& aovs, const std::vector<std::uint32_t>& words,
                              const DevelopedFilm& developed);

}  // namespace vernier
