#include "render/read_film.h"

#include <algorithm>

#include "render/develop.h"
#include "render/film_layer.h"

namespace vernier {

bool wants_geometry(const RenderSettings& settings) {
  return !std::ranges::all_of(settings.aovs, is_film_aov);
}

ImageFile read_film(const Device& device, const Film& film, const RenderSettings& settings,
                    RenderStatistics& statistics) {
  const PixelRect& area = film.area();
  const std::vector<std::uint32_t> sums = film.read_sums(device);
  DevelopedFilm developed = develop(sums, area);
  statistics.non_finite_pixels = developed.non_finite_pixels;
  statistics.first_non_finite = developed.first_non_finite;
  statistics.samples_done = developed.least_samples;
  statistics.mean_samples = developed.mean_samples;
  const std::vector<std::uint32_t> aov_words =
      wants_geometry(settings) ? film.read_aovs(device) : std::vector<std::uint32_t>{};
  std::vector<Layer> layers = aov_layers(settings.aovs, aov_words, developed);
  layers.insert(layers.begin(), Layer{"", {"R", "G", "B", "A"}, std::move(developed.color)});
  if (settings.film_layer) layers.push_back(film_layer(sums));
  return {.width = area.width,
          .height = area.height,
          .x = area.x,
          .y = area.y,
          .full_width = settings.width,
          .full_height = settings.height,
          .layers = std::move(layers),
          .metadata = {}};
}

}  // namespace vernier
