#include "render/trace_film.h"

#include <chrono>

#include "render/adaptive_trace.h"
#include "render/tile_schedule.h"
#include "render/tile_tracer.h"

namespace vernier {
namespace {

using Clock = std::chrono::steady_clock;

std::uint64_t total(const RayCounts& rays) {
  return rays.primary + rays.shadow + rays.reflection + rays.refraction;
}

RenderProgress progress_at(double share, const RayCounts& rays, double seconds) {
  return {.share = share,
          .rays_per_s = seconds > 0.0 ? static_cast<double>(total(rays)) / seconds : 0.0,
          .eta_s = share > 0.0 ? seconds * (1.0 - share) / share : 0.0,
          .rays = total(rays)};
}

/// Every sample of the settings at every pixel, pass by pass.
void trace_passes(TileTracer& tracer, const RenderSettings& settings, const std::function<bool()>& stop,
                  const std::function<void(double)>& progress) {
  const std::vector<PixelRect> tiles = tracer.tiles();
  const double sample_count = static_cast<double>(settings.sample_end - settings.sample_begin);
  for (const SamplePass& pass : schedule_passes(settings.sample_begin, settings.sample_end, tracer.most_samples())) {
    for (std::size_t t = 0; t < tiles.size(); ++t) {
      if (!tracer.run_tile(tiles[t], pass, stop)) return;
      const double pass_share = pass.length() * static_cast<double>(t + 1) / static_cast<double>(tiles.size());
      progress((pass.begin - settings.sample_begin + pass_share) / sample_count);
    }
  }
}

}  // namespace

FilmTracer::FilmTracer(const Device& device, const GpuScene& scene, SceneLoads loads,
                       const TraceSpecialization& specialization, const RenderSettings& settings, Film& film)
    : device_(device),
      settings_(settings),
      film_(film),
      tracer_(std::make_unique<TileTracer>(device, scene, loads, specialization, settings, film)) {}

FilmTracer::~FilmTracer() = default;
FilmTracer::FilmTracer(FilmTracer&&) noexcept = default;

TraceStatistics FilmTracer::trace(const RenderCallbacks& callbacks) {
  const auto start = Clock::now();
  const auto seconds = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };
  const auto stop = [&] {
    return (callbacks.cancelled && callbacks.cancelled()) || seconds() > settings_.time_limit_s;
  };
  const auto progress = [&](double share) {
    if (callbacks.progress) callbacks.progress(progress_at(share, tracer_->statistics().rays, seconds()));
  };
  std::optional<ErrorEstimate> error;
  if (settings_.error_target) {
    error = trace_to_target(device_, *tracer_, film_, settings_, stop, progress);
  } else {
    trace_passes(*tracer_, settings_, stop, progress);
  }
  TraceStatistics statistics = tracer_->statistics();
  statistics.error = error;
  if (!statistics.effect_runs.by_depth.empty()) statistics.effect_runs.by_depth[0].path = statistics.rays.primary;
  statistics.wall_ms = seconds() * 1000.0;
  return statistics;
}

}  // namespace vernier
