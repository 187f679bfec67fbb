#pragma once

#include <memory>

#include "render/film.h"
#include "render/film_file.h"
#include "render/gpu_scene.h"
#include "render/render_image.h"
#include "render/trace_pipeline.h"
#include "render/trace_statistics.h"

namespace vernier {

class TileTracer;

/// Pipelines and buffers that trace into a film, compiled once for any number of traces. Device, scene and film outlive
/// it.
class FilmTracer {
 public:
  /// Compiles the kernels for `specialization`. `settings` say which samples of which tiles.
  FilmTracer(const Device& device, const GpuScene& scene, SceneLoads loads, const TraceSpecialization& specialization,
             const RenderSettings& settings, Film& film);
  ~FilmTracer();
  FilmTracer(FilmTracer&&) noexcept;

  /// Adds the samples of the settings to the film, tile by tile and pass by pass, or what their error target asks for
  /// (trace_to_target), in dispatches of about settings.dispatch_ms. Stops between dispatches when cancelled or past
  /// the time limit. What it took adds up over all traces, but for wall_ms, which is this one's. With
  /// callbacks.resumed, whose sums are in the film, it goes on from there and counts what that had cost;
  /// callbacks.checkpoint saves now and then, and when stopped. Throws Error(device_lost), Error(failed) when a single
  /// ray takes more steps than the driver lets a shader take, and Error(refused) for a resumed film of another
  /// schedule.
  TraceStatistics trace(const RenderCallbacks& callbacks);
  /// The same for the samples of `settings` in the pixels `area` at the upper left of the film; the device has been
  /// told of settings of that size. Without an error target.
  TraceStatistics trace_part(const PixelRect& area, const RenderSettings& settings, const RenderCallbacks& callbacks);

  /// A trace that can be stopped and taken up again: goes on from `position`, which is start_of(settings) at first, and
  /// leaves there how far it came. Tiles that were stopped half-way are traced anew, so that the bits are those of one
  /// trace. The film is not emptied in between.
  TraceStatistics trace_on(TracePosition& position, const RenderSettings& settings, const RenderCallbacks& callbacks);
  /// Nothing of the samples of `settings` is done.
  TracePosition start_of(const RenderSettings& settings) const;

  /// From now on traces take the samples of `settings`: any number of them, of the same area, and an error target only
  /// where the specialization lists pixels.
  void set_settings(const RenderSettings& settings) { settings_ = settings; }

 private:
  const Device& device_;
  RenderSettings settings_;
  Film& film_;
  std::unique_ptr<TileTracer> tracer_;
};

}  // namespace vernier
