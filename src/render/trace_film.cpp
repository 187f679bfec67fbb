#include "render/trace_film.h"

#include <chrono>

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

}  // namespace

FilmTracer::FilmTracer(const Device& device, const GpuScene& scene, SceneLoads loads,
                       const TraceSpecialization& specialization, const RenderSettings& settings, Film& film)
    : settings_(settings),
      tracer_(std::make_unique<TileTracer>(device, scene, loads, specialization, settings, film)) {}

FilmTracer::~FilmTracer() = default;
FilmTracer::FilmTracer(FilmTracer&&) noexcept = default;

TraceStatistics FilmTracer::trace(const RenderCallbacks& callbacks) {
  const auto start = Clock::now();
  const auto seconds = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };
  const auto stop = [&] {
    return (callbacks.cancelled && callbacks.cancelled()) || seconds() > settings_.time_limit_s;
  };
  const std::vector<PixelRect> tiles = tracer_->tiles();
  const std::vector<SamplePass> passes =
      schedule_passes(settings_.sample_begin, settings_.sample_end, tracer_->most_samples());
  const double sample_count = static_cast<double>(settings_.sample_end - settings_.sample_begin);
  bool going = true;
  for (std::size_t p = 0; going && p < passes.size(); ++p) {
    for (std::size_t t = 0; going && t < tiles.size(); ++t) {
      going = tracer_->run_tile(tiles[t], passes[p], stop);
      if (!callbacks.progress) continue;
      const double pass_share =
          (passes[p].end - passes[p].begin) * static_cast<double>(t + 1) / static_cast<double>(tiles.size());
      const double done = (passes[p].begin - settings_.sample_begin + pass_share) / sample_count;
      callbacks.progress(progress_at(done, tracer_->statistics().rays, seconds()));
    }
  }
  TraceStatistics statistics = tracer_->statistics();
  if (!statistics.effect_runs.by_depth.empty()) statistics.effect_runs.by_depth[0].path = statistics.rays.primary;
  statistics.wall_ms = seconds() * 1000.0;
  return statistics;
}

}  // namespace vernier
