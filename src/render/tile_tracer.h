#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "gpu/submission.h"
#include "render/film.h"
#include "render/gpu_scene.h"
#include "render/render_settings.h"
#include "render/tile_schedule.h"
#include "render/trace_pipeline.h"
#include "render/trace_statistics.h"
#include "shared/film_layout.h"

namespace vernier {

/// Pipelines and buffers of the trace and the accumulate kernel, and what they have counted so far. Takes passes of
/// tiles into a film; which, and in what order, its caller says. Device, scene and film outlive it.
class TileTracer {
 public:
  /// Compiles the kernels for `specialization`; passes have at most the samples of `settings`.
  TileTracer(const Device& device, const GpuScene& scene, SceneLoads loads, const TraceSpecialization& specialization,
             const RenderSettings& settings, Film& film);

  /// The film's area in tiles that suit the buffers.
  std::vector<PixelRect> tiles() const { return schedule_tiles(film_.area(), tile_, film_.band_height()); }
  /// Pixels of a tile that is whole.
  glm::ivec2 tile() const { return tile_; }
  /// Samples of a pass at most.
  std::uint32_t most_samples() const { return most_samples_; }
  const TraceStatistics& statistics() const { return statistics_; }

  /// Takes `pass` of `tile` to its end, in as many dispatches as the time budget asks for, and adds it to the film.
  /// False when `stop` said so before; then nothing is added. Throws Error(device_lost), and Error(failed) for a ray
  /// that takes more steps than the driver lets a shader take.
  bool run_tile(const PixelRect& tile, const SamplePass& pass, const std::function<bool()>& stop);

 private:
  void note_saved(const RenderSettings& settings);
  double warm_up();
  void trace(std::uint32_t invocations, const Dispatch& accumulate, const PixelRect& tile,
             std::uint32_t (&counts)[COUNTER_COUNT]);

  const GpuScene& scene_;
  Submitter submitter_;
  glm::ivec2 tile_;
  std::uint32_t most_samples_;
  double wanted_ms_;
  std::uint32_t invocations_;
  Film& film_;
  Buffer counters_, paths_, samples_, unused_, dispatch_;
  ComputePipeline trace_, accumulate_;
  BindingSet trace_bindings_;
  std::vector<BindingSet> accumulate_bindings_;
  double ms_per_search_;
  TraceStatistics statistics_;
};

}  // namespace vernier
