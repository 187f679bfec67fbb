#pragma once

#include <cstdint>
#include <functional>

#include "gpu/device.h"
#include "image/image.h"
#include "render/pack_scene.h"
#include "render/render_settings.h"
#include "render/render_statistics.h"
#include "scene/scene.h"

namespace vernier {

/// How far a render is.
struct RenderProgress {
  double share = 0.0;       ///< of the samples, in [0, 1]
  double rays_per_s = 0.0;  ///< since the start
  double eta_s = 0.0;       ///< what is left at this pace; 0 while unknown
  std::uint64_t rays = 0;
};

class Checkpoint;
struct SavedFilm;

/// How a render talks to its caller; all may be empty. Called between submissions, on the caller's thread.
struct RenderCallbacks {
  std::function<void(const RenderProgress&)> progress;
  std::function<bool()> cancelled;     ///< true: stop cleanly; what is finished is returned
  Checkpoint* checkpoint = nullptr;    ///< saves what is done
  const SavedFilm* resumed = nullptr;  ///< what to go on from: a film of the same scene, settings, device and program
};

/// The colour layer (name "") with R G B A and the AOVs asked for, in that order, and what it took.
struct RenderResult {
  ImageFile image;
  RenderStatistics statistics;
};

/// Throws Error(usage) for settings that make no sense, and what require_loads does for a traversal that `device`
/// lacks.
void check_settings(const RenderSettings& settings, const DeviceDescription& device);

/// Renders `scene`, which has passed validate_scene, through `camera` on `device`: shaders/README.md, "Image
/// formation". The image has the same bits for any tile, dispatch_ms, crop and repetition on one device. Pixels with a
/// sample that is not finite are NaN and counted. A resumed render has the bits of one that was never interrupted.
/// Throws Error: what check_settings does, refused for what the device cannot hold and for a resumed film that does not
/// fit, device_lost.
RenderResult render_image(const Device& device, const Scene& scene, const Camera& camera,
                          const RenderSettings& settings, const RenderCallbacks& callbacks);

/// The same where `shape` is that of the scene (pack_shape) for `settings`, which have passed check_settings.
RenderResult render_image(const Device& device, const Scene& scene, PackedScene shape, const Camera& camera,
                          const RenderSettings& settings, const RenderCallbacks& callbacks);

}  // namespace vernier
