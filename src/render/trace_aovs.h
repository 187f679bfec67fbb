#pragma once

#include "gpu/submission.h"
#include "render/film.h"
#include "render/gpu_scene.h"
#include "render/render_statistics.h"
#include "render/trace_pipeline.h"

namespace vernier {

/// A pipeline that writes the AOVs of a film, compiled once for any number of views. Device, scene and film outlive it.
class AovTracer {
 public:
  /// Compiles for `film`, which has room for AOVs.
  AovTracer(const Device& device, const GpuScene& scene, SceneLoads loads, const TraceSpecialization& specialization,
            Film& film);

  /// Writes the AOVs of the pixels `area` at the upper left of the film, whose view the device has been told of.
  /// Throws Error(device_lost).
  void trace(const PixelRect& area);
  /// What compiling took.
  double compile_ms() const { return pipeline_.compile_ms(); }

 private:
  const GpuScene& scene_;
  Film& film_;
  Submitter submitter_;
  int tile_side_;
  Buffer dispatch_values_;
  ComputePipeline pipeline_;
  std::vector<BindingSet> bindings_;  // of each band
};

/// Writes the AOVs of every pixel of `film`, which has room for them. Returns what compiling its pipeline took.
/// Throws Error(device_lost).
PipelineTime trace_aovs(const Device& device, const GpuScene& scene, SceneLoads loads,
                        const TraceSpecialization& specialization, Film& film);

}  // namespace vernier
