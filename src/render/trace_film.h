#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "gpu/submission.h"
#include "render/film.h"
#include "render/gpu_scene.h"
#include "render/render_image.h"
#include "render/trace_pipeline.h"

namespace vernier {

/// What tracing took.
struct TraceStatistics {
  RayCounts rays;
  std::uint64_t stack_overflows = 0;
  double device_ms = 0.0;
  double wall_ms = 0.0;
  std::vector<PipelineTime> pipelines;  ///< with the first dispatch, at which some drivers compile
  EffectRuns effect_runs;               ///< empty unless the specialization counts effects
  std::uint64_t device_bytes = 0;       ///< of the buffers that tracing alone needs
  SavedMemory saved;                    ///< of these buffers
};

class Tracer;

/// Pipelines and buffers that trace into a film, compiled once for any number of traces. Device, scene and film outlive
/// it.
class FilmTracer {
 public:
  /// Compiles the kernels for `specialization`. `settings` say which samples of which tiles.
  FilmTracer(const Device& device, const GpuScene& scene, SceneLoads loads, const TraceSpecialization& specialization,
             const RenderSettings& settings, Film& film);
  ~FilmTracer();
  FilmTracer(FilmTracer&&) noexcept;

  /// Adds the samples of the settings to the film, tile by tile and pass by pass, in dispatches of about
  /// settings.dispatch_ms. Stops between dispatches when cancelled or past the time limit. What it took adds up over
  /// all traces, but for wall_ms, which is this one's. Throws Error(device_lost), and Error(failed) when a single ray
  /// takes more steps than the driver lets a shader take.
  TraceStatistics trace(const RenderCallbacks& callbacks);

 private:
  RenderSettings settings_;
  std::unique_ptr<Tracer> tracer_;
};

}  // namespace vernier
