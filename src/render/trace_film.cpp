#include "render/trace_film.h"

#include <algorithm>
#include <chrono>

#include "error.h"
#include "math/elapsed.h"
#include "render/adaptive_trace.h"
#include "render/checkpoint.h"
#include "render/tile_schedule.h"
#include "render/tile_tracer.h"

namespace vernier {
namespace {

using Clock = std::chrono::steady_clock;

/// `share` is done, `gained` of it in these `seconds`.
RenderProgress progress_at(double share, double gained, const RayCounts& rays, double seconds) {
  return {.share = share,
          .rays_per_s = seconds > 0.0 ? static_cast<double>(total(rays)) / seconds : 0.0,
          .eta_s = gained > 0.0 ? seconds * (1.0 - share) / gained : 0.0,
          .rays = total(rays)};
}

/// Adds what the film had cost before it was resumed.
void add_before(const SavedFilm& before, TraceStatistics& statistics) {
  statistics.rays.primary += before.rays.primary;
  statistics.rays.shadow += before.rays.shadow;
  statistics.rays.reflection += before.rays.reflection;
  statistics.rays.refraction += before.rays.refraction;
  statistics.stack_overflows += before.stack_overflows;
  statistics.device_ms += before.device_ms;
  statistics.wall_ms += before.wall_ms;
}

/// One trace into a film, with its schedule and where it stands.
class TraceRun {
 public:
  TraceRun(const Device& device, TileTracer& tracer, const Film& film, const PixelRect& area,
           const RenderSettings& settings, const RenderCallbacks& callbacks, const TracePosition& position)
      : device_(device),
        tracer_(tracer),
        film_(film),
        settings_(settings),
        callbacks_(callbacks),
        tiles_(tracer.tiles(area)),
        passes_(
            schedule_passes(settings.sample_begin, settings.sample_end, settings.first_pass, tracer.most_samples())),
        position_(position) {
    check_position();
    if (settings_.error_target) adaptive_ = adaptive_position();
    share_before_ = share();
  }

  /// Traces what is left, and saves it now and then, and where it is stopped.
  void trace() {
    Checkpoint* checkpoint = callbacks_.checkpoint;
    if (checkpoint && !callbacks_.resumed) checkpoint->save_start(film_.area(), position_);
    if (adaptive_) {
      trace_adaptively();
    } else {
      stopped_ = !trace_passes();
    }
    if (checkpoint && stopped_) save();
  }

  const TracePosition& position() const { return position_; }

  TraceStatistics statistics() const {
    TraceStatistics statistics = tracer_.statistics();
    statistics.wall_ms = seconds() * 1000.0;
    if (adaptive_) statistics.error = estimate_at(*adaptive_);
    statistics.stopped = stopped_;
    if (!statistics.effect_runs.by_depth.empty()) statistics.effect_runs.by_depth[0].path = statistics.rays.primary;
    if (callbacks_.resumed) add_before(*callbacks_.resumed, statistics);
    return statistics;
  }

 private:
  double seconds() const { return seconds_since(start_); }

  /// Refuses a saved position that is none of this schedule: one of other limits of the device.
  void check_position() const {
    const auto begins_here = [&](const SamplePass& pass) { return pass.begin == position_.pass_begin; };
    const bool is_scheduled =
        settings_.error_target || (std::ranges::any_of(passes_, begins_here) && position_.tiles_done <= tiles_.size());
    if (position_.tile == tracer_.tile() && is_scheduled) return;
    throw Error(ErrorKind::refused, "--resume: the checkpoint stands in another order of tiles and samples");
  }

  bool is_stopped() const {
    return (callbacks_.cancelled && callbacks_.cancelled()) || seconds() > settings_.time_limit_s;
  }

  void tell(double share) const {
    if (!callbacks_.progress) return;
    callbacks_.progress(progress_at(share, share - share_before_, tracer_.statistics().rays, seconds()));
  }

  AdaptivePosition adaptive_position() const {
    const PixelRect& area = film_.area();
    const bool has_errors = callbacks_.resumed && !callbacks_.resumed->errors.empty();
    return {
        has_errors ? ErrorMap(area.width, area.height, callbacks_.resumed->errors) : ErrorMap(area.width, area.height),
        position_.pass_begin, position_.tiles_done};
  }

  void trace_adaptively() {
    AdaptiveCallbacks callbacks;
    callbacks.stop = [this] { return stopped_ = is_stopped(); };
    callbacks.progress = [this](double share) { tell(share); };
    callbacks.after_pass = [this] { save_if_due(); };
    trace_to_target(device_, tracer_, film_, settings_, *adaptive_, callbacks);
  }

  /// False when it was stopped.
  bool trace_passes() {
    const auto stop = [this] { return is_stopped(); };
    for (const SamplePass& pass : passes_) {
      if (pass.begin < position_.pass_begin) continue;
      if (pass.begin > position_.pass_begin) position_ = {position_.tile, pass.begin, 0};
      while (position_.tiles_done < tiles_.size()) {
        if (!tracer_.run_tile(tiles_[position_.tiles_done], pass, stop)) return false;
        ++position_.tiles_done;
        tell(share());
        save_if_due();
      }
    }
    return true;
  }

  void save_if_due() {
    if (callbacks_.checkpoint && callbacks_.checkpoint->is_due(film_.size_bytes())) save();
  }

  void save() {
    if (adaptive_) position_ = {position_.tile, adaptive_->round, adaptive_->passes_done};
    callbacks_.checkpoint->save(device_, film_, position_, statistics(),
                                adaptive_ ? adaptive_->errors.pixels() : std::vector<PixelError>());
  }

  /// Share of the work that is done.
  double share() const {
    if (adaptive_) return share_at(*adaptive_, *settings_.error_target);
    const auto pass = std::ranges::find(passes_, position_.pass_begin, &SamplePass::begin);
    const double pass_share =
        pass->length() * static_cast<double>(position_.tiles_done) / static_cast<double>(tiles_.size());
    return (pass->begin - settings_.sample_begin + pass_share) / (settings_.sample_end - settings_.sample_begin);
  }

  const Device& device_;
  TileTracer& tracer_;
  const Film& film_;
  const RenderSettings& settings_;
  const RenderCallbacks& callbacks_;
  std::vector<PixelRect> tiles_;
  std::vector<SamplePass> passes_;
  TracePosition position_;
  double share_before_ = 0.0;
  std::optional<AdaptivePosition> adaptive_;  ///< with an error target
  bool stopped_ = false;
  Clock::time_point start_ = Clock::now();
};

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
  return trace_part(film_.area(), settings_, callbacks);
}

TraceStatistics FilmTracer::trace_part(const PixelRect& area, const RenderSettings& settings,
                                       const RenderCallbacks& callbacks) {
  const TracePosition start = callbacks.resumed ? callbacks.resumed->position : start_of(settings);
  TraceRun run(device_, *tracer_, film_, area, settings, callbacks, start);
  run.trace();
  return run.statistics();
}

TraceStatistics FilmTracer::trace_on(TracePosition& position, const RenderSettings& settings,
                                     const RenderCallbacks& callbacks) {
  TraceRun run(device_, *tracer_, film_, film_.area(), settings, callbacks, position);
  run.trace();
  position = run.position();
  return run.statistics();
}

TracePosition FilmTracer::start_of(const RenderSettings& settings) const {
  return {tracer_->tile(), settings.sample_begin, 0};
}

}  // namespace vernier
