#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "image/image.h"
#include "render/develop.h"
#include "render/film.h"
#include "render/gpu_scene.h"
#include "render/pack_scene.h"
#include "render/trace_film.h"
#include "render/trace_pipeline.h"

namespace vernier {

/// A scene on a device, to be traced in several ways.
class StagedScene {
 public:
  /// Packs and uploads `scene`, which has passed validate_scene, seen through `camera`; `device` outlives it.
  StagedScene(const Device& device, const Scene& scene, const Camera& camera, const RenderSettings& settings);
  /// The same for a scene that pack_scene has packed, on whatever thread.
  StagedScene(const Device& device, PackedScene packed, const Camera& camera, const RenderSettings& settings);

  const Device& device() const { return device_; }
  const PackedScene& packed() const { return packed_; }
  const GpuScene& gpu_scene() const { return gpu_scene_; }
  SceneLoads loads() const { return loads_; }
  /// What the kernels are specialized to for `effects` at the settings' accuracy.
  TraceSpecialization specialization(std::uint32_t effects) const;
  /// Traces begun from now on have the seed, samples, bounces, cutoff and filters of `settings`, whose size is the
  /// first one's.
  void set_settings(const RenderSettings& settings);
  /// Traces begun from now on see through `camera` with `settings`, of any size.
  void set_view(const Camera& camera, const RenderSettings& settings);
  /// Traces begun from now on have these lights, as many as before.
  void set_lights(const std::vector<Light>& lights);

 private:
  const Device& device_;
  RenderSettings settings_;
  SceneLoads loads_;
  PackedScene packed_;
  GpuScene gpu_scene_;
};

/// What one trace took.
struct TraceTime {
  double device_ms = 0.0;
  RayCounts rays;
  double wall_ms = 0.0;
  SavedMemory saved;  ///< of all its buffers, against a pipeline with every effect, all AOVs and the cost
};

/// A pipeline of its own and a film, timed again and again. What it is compared with should be traced right before:
/// a busy machine slows both.
class TimedTrace {
 public:
  /// Compiles for `specialization` before the clock starts. `scene` outlives it.
  TimedTrace(const StagedScene& scene, const TraceSpecialization& specialization, const RenderSettings& settings);

  /// Traces all samples of the settings once more, or those that come before `stop` says so.
  TraceTime trace(const std::function<bool()>& stop = {});
  /// Empties the film and traces the samples of `settings`, which StagedScene::set_settings has told the device of, as
  /// far as they come before `stop` says so.
  TraceTime trace_anew(const RenderSettings& settings, const std::function<bool()>& stop = {});
  /// The picture so far, R G B A. Repeated traces of the same samples leave it as it is.
  Image picture() const;
  /// The film as values: samples of each pixel, pixels that are not finite.
  DevelopedFilm developed() const { return develop(film_.read_sums(device_), film_.area()); }
  /// Of both kernels, with the first dispatch. 0 before the first trace.
  double compile_ms() const { return compile_ms_; }

 private:
  const Device& device_;
  Film film_;
  FilmTracer tracer_;
  TraceTime before_;
  double compile_ms_ = 0.0;
};

}  // namespace vernier
