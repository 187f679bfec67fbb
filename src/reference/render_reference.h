#pragma once

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
  unsigned thread_count = 0;  ///< 0: all cores
};

/// The image that `scene` forms through `camera` by shaders/README.md, "Image formation", in double precision,
/// by code that shares nothing with the shaders or the BVH. Layers: colour R G B A; depth.Z, position.XYZ,
/// normal.XYZ, shading_normal.XYZ, uv.UV, albedo.RGB, object_id.ID, material_id.ID, primitive_id.ID at the pixel
/// centre; sample_ids: uint32 [height][width][spp], the global triangle id of every sample's primary ray (4294967295
/// for a miss); edge_distance: float [height][width][spp], the smallest barycentric coordinate of that hit, and for a
/// miss the distance to the nearest silhouette in the same measure where below 1e-4, else 1: the oracle for "within its error
/// bound of an edge". `progress` (may be empty) gets the share done in [0, 1] from any thread.
ImageFile render_reference(const Scene& scene, const Camera& camera, const ReferenceSettings& settings,
                           const std::function<void(double)>& progress);

}  // namespace vernier
