#pragma once

#include <array>
#include <functional>

#include "render/render_image.h"
#include "verify/image_scenes.h"
#include "verify/tally.h"

namespace vernier {

/// A rendered picture; each of its pixels is a sample of a case.
struct Picture {
  int width = 0;
  int height = 0;
  std::vector<Layer> layers;       ///< colour, then the AOVs asked for
  std::uint64_t dropped_rays = 0;  ///< for want of stack
  std::uint64_t number = 0;        ///< of the case's pictures

  /// All of them.
  std::size_t pixel_count() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
  /// Colour of a pixel, row by row.
  glm::vec3 color(std::size_t pixel) const;
  /// `picture 1, pixel 12,34: r=0x1p0 ...`
  std::string inputs(std::size_t pixel) const;
};

/// `side` x `side` pixels, a sample at each pixel's centre, no cutoff, at the levels and with the mutation of `setup`.
RenderSettings picture_settings(const CaseSetup& setup, int side);

/// Renders `scene`; the rest of what render_image tells is dropped.
Picture render_picture(const CaseSetup& setup, const ImageScene& scene, const RenderSettings& settings);

/// A ray in double.
struct PixelRay {
  glm::dvec3 origin;
  glm::dvec3 direction;  ///< unit
};

/// The ray through the centre of a pixel of a picture through `camera`. shaders/README.md, Image formation 1 and 2.
PixelRay pixel_ray(const Camera& camera, const Picture& picture, std::size_t pixel);

/// The same ray turned a hair to four sides, and itself: what an oracle says of all of them does not hang on rounding.
/// `angle` in radians.
std::array<PixelRay, 5> nearby_rays(const PixelRay& ray, double angle);

/// Lets `take` render and book picture after picture, until they have setup.sample_count pixels or there are
/// `most_pictures`. The random numbers are a function of seed, case and picture.
void for_each_picture(const CaseSetup& setup, const char* name, int side, std::uint64_t most_pictures,
                      const std::function<void(SampleRandom& random, std::uint64_t number)>& take);

/// Books every pixel of `picture`: its colour is finite, no ray of the picture was dropped, and `holds(pixel)`.
void book_pixels(Tally& tally, const Picture& picture, const std::function<bool(std::size_t pixel)>& holds);

/// The same for `error(pixel)`; NaN where the colour is not finite or a ray was dropped.
void book_pixel_errors(Tally& tally, const Picture& picture, const std::function<double(std::size_t pixel)>& error);

/// Whether the colours of two pictures have the same bits at a pixel, alpha included.
bool same_bits(const Picture& a, const Picture& b, std::size_t pixel);

}  // namespace vernier
