#include "reference/pixel_samples.h"

#include "error.h"
#include "reference/sample_positions.h"

namespace vernier::reference {

void check_settings(const ReferenceSettings& settings) {
  if (settings.width < 1 || settings.height < 1)
    throw Error(ErrorKind::usage, "reference: size: width and height must be at least 1 pixel");
  if (settings.spp < 1) throw Error(ErrorKind::usage, "reference: spp: must be at least 1");
  if (!(settings.cutoff >= 0.0)) throw Error(ErrorKind::usage, "reference: cutoff: must be 0 or more");
}

Ray sample_ray(const Camera& camera, const ReferenceSettings& settings, int x, int y, std::uint32_t sample) {
  const glm::dvec2 within = sample_position(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), sample,
                                            settings.spp, settings.seed);
  const glm::dvec2 place = settings.tent_filter ? tent_position(within) : within;
  return camera_ray(camera, settings.width, settings.height, glm::dvec2(x, y) + place);
}

}  // namespace vernier::reference
