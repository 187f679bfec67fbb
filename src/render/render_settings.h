#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bvh/build_method.h"
#include "render/traversal_form.h"

namespace vernier {

/// A rectangle of pixels, (x, y) its upper left corner.
struct PixelRect {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
};

/// Numeric level (README, Accuracy): what most renderers do; bounded errors; twice the precision.
enum class Accuracy { fast, robust, exact };
inline constexpr std::array kAccuracies{Accuracy::fast, Accuracy::robust, Accuracy::exact};

/// The level's name on the command line.
constexpr std::string_view to_string(Accuracy accuracy) {
  return accuracy == Accuracy::fast ? "fast" : accuracy == Accuracy::robust ? "robust" : "exact";
}

/// How a pixel weighs its samples: all alike, or by a tent two pixels wide, which takes in its neighbours' halves.
enum class PixelFilter { box, tent };
inline constexpr std::array kPixelFilters{PixelFilter::box, PixelFilter::tent};

/// How textures are looked up: as their file says, or all of them one way.
enum class TextureFilter { file, nearest, linear };
inline constexpr std::array kTextureFilters{TextureFilter::file, TextureFilter::nearest, TextureFilter::linear};

/// The filters' names on the command line.
constexpr std::string_view to_string(PixelFilter filter) {
  return filter == PixelFilter::box ? "box" : "tent";
}
constexpr std::string_view to_string(TextureFilter filter) {
  return filter == TextureFilter::file ? "file" : filter == TextureFilter::nearest ? "nearest" : "linear";
}

/// What becomes of meshes that a scene uses more than once (plan_instances.h).
enum class Sharing {
  automatic,  ///< they are copied as long as that costs little memory, since rays are quicker then
  never,      ///< always copied
  always      ///< no mesh is copied, not even one that is used once
};

/// What decides the image and how it is made. The defaults are the command line's.
struct RenderSettings {
  int width = 1280;
  int height = 720;
  std::optional<PixelRect> crop;   ///< part of the image; its bits equal the same pixels of the whole
  std::uint32_t sample_begin = 0;  ///< first sample of every pixel
  std::uint32_t sample_end = 16;   ///< one past the last
  std::uint32_t spp = 16;          ///< samples of the whole image: 1 samples the pixel centre
  std::uint32_t max_bounces = 8;   ///< reflections and refractions one after the other
  float cutoff = 0.0009765625f;    ///< a ray of a weight below is not traced; 0 cuts only weight 0
  Accuracy accuracy = Accuracy::robust;
  std::string effects = "auto";
  PixelFilter pixel_filter = PixelFilter::box;
  TextureFilter texture_filter = TextureFilter::file;
  glm::ivec2 tile = glm::ivec2(0);  ///< pixels; 0: chosen. Never changes a bit
  double dispatch_ms = 100.0;       ///< time budget of one submission
  BuildMethod bvh = BuildMethod::standard;
  TraversalForm traversal = TraversalForm::automatic;  ///< never changes a bit
  std::uint32_t first_pass = 1;        ///< samples of the first pass over all pixels. Never changes a bit
  std::optional<double> error_target;  ///< sqrt(relMSE) at which sampling stops; spp is then the most of a pixel
  double time_limit_s = std::numeric_limits<double>::infinity();
  std::uint32_t seed = 0;
  bool count_effects = false;            ///< counts how often each effect runs: slower, never changes a bit
  bool film_layer = false;               ///< adds the layer `film` (film_layer.h): the sums, for merging
  std::vector<std::string> aovs;         ///< names of cli.md's --aov
  Sharing sharing = Sharing::automatic;  ///< of meshes; tests alone set it
  // `vernier verify` alone sets these two (shared/accuracy.h).
  std::optional<std::uint32_t> spot_levels;  ///< the level of each spot, instead of `accuracy`
  std::uint32_t mutation = 0;                ///< MUTATION_*, a fault to seed; 0: none
};

/// The pixels that are rendered.
inline PixelRect image_area(const RenderSettings& settings) {
  return settings.crop.value_or(PixelRect{0, 0, settings.width, settings.height});
}

/// Width over height of the whole image.
inline double aspect_of(const RenderSettings& settings) {
  return static_cast<double>(settings.width) / settings.height;
}

/// Whether the layer `aov` is asked for.
inline bool wants_aov(const RenderSettings& settings, std::string_view aov) {
  return std::ranges::find(settings.aovs, aov) != settings.aovs.end();
}

}  // namespace vernier
