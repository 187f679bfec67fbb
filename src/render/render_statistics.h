#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "effects/effect_set.h"

namespace vernier {

/// Rays by kind. What goes on behind a mask or a blended pane is the same ray.
struct RayCounts {
  std::uint64_t primary = 0;
  std::uint64_t shadow = 0;
  std::uint64_t reflection = 0;
  std::uint64_t refraction = 0;
};

/// One sample of one pixel of the full image.
struct SamplePlace {
  int x = 0;
  int y = 0;
  std::uint32_t sample = 0;
};

/// What a render did and what it took. Times in milliseconds.
struct RenderStatistics {
  EffectSet effects;  ///< as used
  std::uint64_t triangles = 0;
  std::uint64_t instances = 0;
  std::uint64_t materials = 0;
  std::uint64_t textures = 0;
  std::uint64_t bvh_nodes = 0;
  std::uint64_t bvh_bytes = 0;
  double sah_cost = 0.0;
  std::uint32_t bvh_depth = 0;
  double bvh_build_ms = 0.0;
  double pack_ms = 0.0;  ///< baking instances and packing arrays, without the BVH
  double upload_ms = 0.0;
  double compile_ms = 0.0;       ///< shader pipelines
  double trace_device_ms = 0.0;  ///< by timestamps
  double trace_wall_ms = 0.0;
  RayCounts rays;
  std::uint64_t non_finite_pixels = 0;
  SamplePlace first_non_finite;  ///< of those pixels, row by row, the first, and the first such sample of it
  std::uint64_t stack_overflows = 0;
  std::uint32_t samples_done = 0;  ///< samples every pixel has got
  std::uint64_t device_bytes = 0;
  std::string spirv_hash;
  std::vector<std::string> warnings;
};

}  // namespace vernier
