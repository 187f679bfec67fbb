#pragma once

#include <cstdint>
#include <functional>

#include "image/image.h"
#include "scene/scene.h"

namespace vernier {

/// What the reference renders; the fields mean what RenderSettings' of the same name mean.
struct ReferenceSettings {
  int width = 1280;
  int height = 720;
  std::uint32_t spp = 16;
  std::uint32_t max_bounces = 8;
  double cutoff = 0.0009765625;
  std::uint32_t seed = 0;
  bool tent_filter = false;   ///< PixelFilter::tent
  unsigned thread_count = 0;  ///< 0: all cores
};

/// How a reference render talks to its caller; both may be empty. Called from any thread.
struct ReferenceCallbacks {
  std::function<void(double)> progress;  ///< gets the share done in (0, 1], one call at a time
  std::function<bool()> cancelled;       ///< true: stop soon; called by several threads at once
};

/// The image that `scene` forms through `camera` by shaders/README.md, "Image formation", in double precision,
/// by code that shares nothing with the shaders or the BVH. Layers: colour R G B A; depth.Z, position.XYZ,
/// normal.XYZ, shading_normal.XYZ, uv.UV, albedo.RGB, object_id.ID, material_id.ID, primitive_id.ID at the pixel
/// centre. `scene` has passed validate_scene; an empty one shows its environment. The same for every thread count.
/// When cancelled, pixels that were not finished are as those of an empty scene: colour and alpha 0, nothing hit. NaN
/// of the scene is passed on. Throws Error(usage) unless width, height and spp are positive and cutoff is at least 0.
ImageFile render_reference(const Scene& scene, const Camera& camera, const ReferenceSettings& settings,
                           const ReferenceCallbacks& callbacks);

}  // namespace vernier
