#pragma once

#include <cstdint>
#include <functional>
#include <span>
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

/// Bytes of the device for samples and paths, without the stack of waiting rays, which hangs on the effects.
std::uint64_t tracing_bytes(const RenderSettings& settings, const DeviceDescription& device);

/// Pipelines and buffers of the trace and the accumulate kernel, and what they have counted so far. Takes passes of
/// tiles into a film; which, and in what order, its caller says. Device, scene and film outlive it.
class TileTracer {
 public:
  /// Compiles the kernels for `specialization`; passes have at most the samples of `settings`.
  TileTracer(const Device& device, const GpuScene& scene, SceneLoads loads, const TraceSpecialization& specialization,
             const RenderSettings& settings, Film& film);

  /// `area`, which begins at the film's upper left pixel, in tiles that suit the buffers.
  std::vector<PixelRect> tiles(const PixelRect& area) const { return schedule_tiles(area, tile_, film_.band_height()); }
  /// Pixels of a tile that is whole.
  glm::ivec2 tile() const { return tile_; }
  /// Samples of a pass at most.
  std::uint32_t most_samples() const { return most_samples_; }
  const TraceStatistics& statistics() const { return statistics_; }

  /// Takes `pass` of `tile` to its end, in as many dispatches as the time budget asks for, and adds it to the film.
  /// False when `stop` said so before; then nothing is added. Throws Error(device_lost), and Error(failed) for a ray
  /// that takes more steps than the driver lets a shader take.
  bool run_tile(const PixelRect& tile, const SamplePass& pass, const std::function<bool()>& stop);

  /// The same for some pixels of the tile alone, each y << 16 | x within it; at most samples_of_pass(pixels) at once.
  /// The specialization lists pixels.
  bool run_pixels(const PixelRect& tile, std::span<const std::uint32_t> pixels, const SamplePass& pass,
                  const std::function<bool()>& stop);

  /// Samples of a pass at most over so many listed pixels (at least 1) of a tile.
  std::uint32_t samples_of_pass(std::size_t pixels) const;

 private:
  bool run_jobs(DispatchConstants constants, std::uint64_t jobs, const Dispatch& accumulate,
                const std::function<bool()>& stop);
  DispatchConstants pass_constants(const PixelRect& tile, const SamplePass& pass);
  const BindingSet& accumulate_bindings(const PixelRect& tile) const;
  void bind_accumulate(const Device& device, const TraceSpecialization& specialization);
  void note_saved(const RenderSettings& settings);
  double warm_up();
  void run(std::span<const Dispatch> dispatches, const DispatchConstants& constants,
           std::uint32_t (&counts)[COUNTER_COUNT]);

  const GpuScene& scene_;
  Submitter submitter_;
  std::uint64_t sample_bytes_;
  int tile_side_;  ///< unless the settings say another
  glm::ivec2 tile_;
  std::uint32_t most_samples_;
  double wanted_ms_;
  std::uint32_t invocations_;
  Film& film_;
  Buffer counters_, paths_, samples_, pixels_, dispatch_;
  ComputePipeline trace_, accumulate_;
  BindingSet trace_bindings_;
  std::vector<BindingSet> accumulate_bindings_;
  double ms_per_search_;
  TraceStatistics statistics_;
};

}  // namespace vernier
