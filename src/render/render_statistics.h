#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "effects/effect_set.h"
#include "render/effect_runs.h"
#include "render/error_estimate.h"

namespace vernier {

/// Rays by kind. What goes on behind a mask or a blended pane is the same ray.
struct RayCounts {
  std::uint64_t primary = 0;
  std::uint64_t shadow = 0;
  std::uint64_t reflection = 0;
  std::uint64_t refraction = 0;
};

/// Rays of all kinds.
constexpr std::uint64_t total(const RayCounts& rays) {
  return rays.primary + rays.shadow + rays.reflection + rays.refraction;
}

/// One sample of one pixel of the full image.
struct SamplePlace {
  int x = 0;
  int y = 0;
  std::uint32_t sample = 0;
};

/// What it took to make a pipeline ready.
struct PipelineTime {
  std::string name;
  double compile_ms = 0.0;
};

/// Device memory that a pipeline with every effect, all AOVs and the cost would have taken beyond what was allocated.
struct SavedMemory {
  std::uint64_t path_stack_bytes = 0;   ///< places of rays that cannot wait
  std::uint64_t sample_cost_bytes = 0;  ///< nodes and triangles of samples in flight
  std::uint64_t aov_bytes = 0;          ///< first-hit layers
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
  double compile_ms = 0.0;  ///< shader pipelines, all of them
  std::vector<PipelineTime> pipelines;
  double trace_device_ms = 0.0;  ///< by timestamps
  double trace_wall_ms = 0.0;
  RayCounts rays;
  std::uint64_t non_finite_pixels = 0;
  SamplePlace first_non_finite;  ///< of those pixels, row by row, the first, and the first such sample of it
  std::uint64_t stack_overflows = 0;
  std::uint32_t samples_done = 0;      ///< samples every pixel has got
  double mean_samples = 0.0;           ///< per pixel
  bool stopped = false;                ///< by the time limit or the caller, before its end: other runs stop elsewhere
  std::optional<ErrorEstimate> error;  ///< with an error target, once there is one
  std::uint64_t device_bytes = 0;
  SavedMemory saved;
  EffectRuns effect_runs;  ///< only with RenderSettings::count_effects
  std::vector<std::string> warnings;
};

}  // namespace vernier
