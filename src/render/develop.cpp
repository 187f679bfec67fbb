#include "render/develop.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "error.h"
#include "shared/film_layout.h"

namespace vernier {
namespace {

/// Mean of `samples` values whose 96-bit sum starts at `words`.
float mean_of(const std::uint32_t* words, std::uint32_t samples) {
  if (words[2] == FILM_PLAIN_SUM && words[1] == 0) return std::bit_cast<float>(words[0]) / static_cast<float>(samples);
  // Exact but for the last step: a double holds the upper 53 bits, rounded by the first addition that needs it.
  const double sum = std::ldexp(words[2], 64) + (std::ldexp(words[1], 32) + words[0]);
  return static_cast<float>(std::ldexp(sum, -static_cast<int>(FILM_FRACTION_BITS)) / samples);
}

constexpr const char* kSampleCount = "sample_count";
constexpr const char* kCost = "cost";

struct AovShape {
  const char* name;
  std::vector<std::string> channels;
  std::uint32_t first_word;
  bool is_id;
};

const std::vector<AovShape>& aov_shapes() {
  static const std::vector<AovShape> shapes = {{"depth", {"Z"}, AOV_DEPTH, false},
                                               {"position", {"X", "Y", "Z"}, AOV_POSITION, false},
                                               {"normal", {"X", "Y", "Z"}, AOV_NORMAL, false},
                                               {"shading_normal", {"X", "Y", "Z"}, AOV_SHADING_NORMAL, false},
                                               {"uv", {"U", "V"}, AOV_UV, false},
                                               {"albedo", {"R", "G", "B"}, AOV_ALBEDO, false},
                                               {"object_id", {"ID"}, AOV_OBJECT_ID, true},
                                               {"material_id", {"ID"}, AOV_MATERIAL_ID, true},
                                               {"primitive_id", {"ID"}, AOV_PRIMITIVE_ID, true}};
  return shapes;
}

template <typename Value>
std::vector<Value> gathered(const std::vector<std::uint32_t>& words, const AovShape& shape) {
  const std::size_t channel_count = shape.channels.size();
  const std::size_t pixel_count = words.size() / AOV_WORDS;
  std::vector<Value> values(pixel_count * channel_count);
  for (std::size_t pixel = 0; pixel < pixel_count; ++pixel) {
    for (std::size_t c = 0; c < channel_count; ++c) {
      values[pixel * channel_count + c] = std::bit_cast<Value>(words[pixel * AOV_WORDS + shape.first_word + c]);
    }
  }
  return values;
}

Layer geometric_layer(const std::string& name, const std::vector<std::uint32_t>& words) {
  const auto& shapes = aov_shapes();
  const auto shape = std::find_if(shapes.begin(), shapes.end(), [&](const AovShape& s) { return s.name == name; });
  if (shape == shapes.end()) throw Error(ErrorKind::usage, "--aov: there is no AOV '" + name + "'");
  Layer layer{.name = name, .channels = shape->channels, .values = {}};
  if (shape->is_id) {
    layer.values = gathered<std::uint32_t>(words, *shape);
  } else {
    layer.values = gathered<float>(words, *shape);
  }
  return layer;
}

/// Colour and cost of the pixel that `words` are of, which has a sample.
void develop_pixel(const std::uint32_t* words, std::size_t pixel, DevelopedFilm& film) {
  const std::uint32_t samples = words[FILM_SAMPLES];
  const bool finite = words[FILM_NON_FINITE] == 0;
  float* color = film.color.data() + 4 * pixel;
  for (std::uint32_t c = 0; c < 3; ++c) {
    color[c] = finite ? mean_of(words + 3 * c, samples) : std::numeric_limits<float>::quiet_NaN();
    film.cost[3 * pixel + c] = static_cast<float>(static_cast<double>(words[FILM_RAYS + c]) / samples);
  }
  color[3] = static_cast<float>(static_cast<double>(words[FILM_HITS]) / samples);
}

/// Counts a pixel that is not finite; the first one's place is kept.
void note_non_finite(const std::uint32_t* words, std::size_t pixel, const PixelRect& area, DevelopedFilm& film) {
  if (film.non_finite_pixels++ > 0) return;
  const auto width = static_cast<std::size_t>(area.width);
  film.first_non_finite = {.x = area.x + static_cast<int>(pixel % width),
                           .y = area.y + static_cast<int>(pixel / width),
                           .sample = words[FILM_FIRST_NON_FINITE] - 1};
}

}  // namespace

DevelopedFilm develop(const std::vector<std::uint32_t>& sums, const PixelRect& area) {
  DevelopedFilm film;
  const std::size_t pixel_count = sums.size() / FILM_WORDS;
  film.color.assign(4 * pixel_count, 0.0f);
  film.sample_count.resize(pixel_count);
  film.cost.assign(3 * pixel_count, 0.0f);
  film.least_samples = std::numeric_limits<std::uint32_t>::max();
  std::uint64_t total_samples = 0;
  for (std::size_t pixel = 0; pixel < pixel_count; ++pixel) {
    const std::uint32_t* words = sums.data() + pixel * FILM_WORDS;
    const std::uint32_t samples = words[FILM_SAMPLES];
    film.sample_count[pixel] = samples;
    film.least_samples = std::min(film.least_samples, samples);
    total_samples += samples;
    if (samples == 0) continue;
    develop_pixel(words, pixel, film);
    if (words[FILM_NON_FINITE] != 0) note_non_finite(words, pixel, area, film);
  }
  film.mean_samples = static_cast<double>(total_samples) / static_cast<double>(std::max<std::size_t>(pixel_count, 1));
  return film;
}

const std::vector<std::string>& aov_names() {
  static const std::vector<std::string> all = [] {
    std::vector<std::string> names;
    for (const AovShape& shape : aov_shapes()) names.push_back(shape.name);
    names.insert(names.end(), {kSampleCount, kCost});
    return names;
  }();
  return all;
}

bool is_film_aov(std::string_view aov) {
  return aov == kSampleCount || aov == kCost;
}

std::vector<Layer> aov_layers(const std::vector<std::string>& aovs, const std::vector<std::uint32_t>& words,
                              const DevelopedFilm& developed) {
  std::vector<Layer> layers;
  for (const std::string& name : aovs) {
    if (name == kSampleCount) {
      layers.push_back({name, {"N"}, developed.sample_count});
    } else if (name == kCost) {
      layers.push_back({name, {"rays", "nodes", "triangles"}, developed.cost});
    } else {
      layers.push_back(geometric_layer(name, words));
    }
  }
  return layers;
}

}  // namespace vernier
