#include "render/trace_film.h"

#include <chrono>
#include <cstring>
#include <span>

#include "error.h"
#include "render/tile_schedule.h"
#include "shared/bindings.h"
#include "shared/film_layout.h"

namespace vernier {
namespace {

using Clock = std::chrono::steady_clock;

/// Tiles of CPU devices are small: their dispatches then stay within the time budget; a GPU wants more lanes at once.
constexpr int kCpuTile = 64;
constexpr int kGpuTile = 256;
constexpr int kWorkgroup = 8;
/// Taken for the time of a ray until a dispatch of at least kTrustedRays has been timed: a slow CPU.
constexpr double kFirstMsPerRay = 1e-3;
constexpr std::uint32_t kTrustedRays = 1024;

glm::ivec2 chosen_tile(const DeviceDescription& device, const RenderSettings& settings) {
  return settings.tile.x > 0 ? settings.tile : glm::ivec2(device.is_cpu ? kCpuTile : kGpuTile);
}

std::uint32_t group_count(int pixels) {
  return static_cast<std::uint32_t>((pixels + kWorkgroup - 1) / kWorkgroup);
}

DispatchConstants tile_constants(const GpuScene& scene, const PixelRect& tile, const PixelRect& area,
                                 const Film::Band& band) {
  DispatchConstants constants{};
  constants.tile_x = static_cast<std::uint32_t>(tile.x);
  constants.tile_y = static_cast<std::uint32_t>(tile.y);
  constants.tile_width = static_cast<std::uint32_t>(tile.width);
  constants.tile_height = static_cast<std::uint32_t>(tile.height);
  constants.band_x = static_cast<std::uint32_t>(area.x);
  constants.band_y = static_cast<std::uint32_t>(area.y + band.first_row);
  constants.band_width = static_cast<std::uint32_t>(area.width);
  constants.steering = scene.steering();
  return constants;
}

Dispatch tile_dispatch(const ComputePipeline& pipeline, const BindingSet& bindings, const PixelRect& tile) {
  return {.pipeline = &pipeline,
          .bindings = &bindings,
          .push_constants = {},
          .group_count_x = group_count(tile.width),
          .group_count_y = group_count(tile.height),
          .group_count_z = 1};
}

/// A buffer for what changes from dispatch to dispatch (render_constants.h says why not push constants).
Buffer dispatch_buffer(const Device& device) {
  return Buffer(device, sizeof(DispatchConstants), BufferUse::storage_host_visible);
}

void set_dispatch(Buffer& buffer, const DispatchConstants& constants) {
  std::memcpy(buffer.mapped().data(), &constants, sizeof(constants));
}

/// Buffers and pipeline of the trace kernel, and what it has counted so far.
class Tracer {
 public:
  Tracer(const Device& device, const GpuScene& scene, SceneLoads loads, const TraceSpecialization& specialization,
         const RenderSettings& settings, Film& film)
      : scene_(scene),
        submitter_(device),
        tile_(chosen_tile(device.description(), settings)),
        wanted_ms_(settings.dispatch_ms),
        film_(film),
        counters_(device, COUNTER_COUNT * 4, BufferUse::storage_host_visible),
        paths_(device, std::uint64_t(tile_.x) * std::uint64_t(tile_.y) * PATH_WORDS(specialization.path_stack) * 4,
               BufferUse::storage),
        no_aovs_(device, 0, BufferUse::storage),
        dispatch_(dispatch_buffer(device)) {
    for (Film::Band& band : film.bands()) {
      std::vector<Binding> bindings = scene.bindings();
      bindings.insert(bindings.end(), {{BINDING_FILM, &band.sums},
                                       {BINDING_COUNTERS, &counters_},
                                       {BINDING_PATHS, &paths_},
                                       {BINDING_AOVS, &no_aovs_},
                                       {BINDING_DISPATCH, &dispatch_}});
      if (bindings_.empty()) pipeline_ = make_trace_pipeline(device, Kernel::trace, loads, specialization, bindings);
      bindings_.emplace_back(device, pipeline_, bindings);
    }
    statistics_.compile_ms = pipeline_.compile_ms();
    statistics_.device_bytes = counters_.size_bytes() + paths_.size_bytes();
  }

  std::vector<PixelRect> tiles() const { return schedule_tiles(film_.area(), tile_, film_.band_height()); }

  /// Takes `pass` of `tile` to its end, in as many dispatches as the time budget asks for. False when `stop` said so
  /// before.
  template <typename Stop>
  bool run_tile(const PixelRect& tile, const SamplePass& pass, const Stop& stop) {
    const auto band_index = static_cast<std::size_t>((tile.y - film_.area().y) / film_.band_height());
    DispatchConstants constants = tile_constants(scene_, tile, film_.area(), film_.bands()[band_index]);
    constants.sample_begin = pass.begin;
    constants.sample_end = pass.end;
    auto live_pixels = static_cast<std::uint32_t>(tile.width * tile.height);
    while (live_pixels > 0) {
      if (stop()) return false;
      constants.ray_budget = choose_ray_budget(wanted_ms_, ms_per_ray_, live_pixels);
      set_dispatch(dispatch_, constants);
      live_pixels = run(tile_dispatch(pipeline_, bindings_[band_index], tile), tile);
      constants.resume = 1;
    }
    return true;
  }

  const TraceStatistics& statistics() const { return statistics_; }

 private:
  /// Runs one dispatch and books what it did; returns how many pixels want another.
  std::uint32_t run(const Dispatch& dispatch, const PixelRect& tile) {
    std::uint32_t counts[COUNTER_COUNT] = {};
    std::memcpy(counters_.mapped().data(), counts, sizeof(counts));
    const SubmissionTime time = submitter_.run(std::span(&dispatch, 1));
    std::memcpy(counts, counters_.mapped().data(), sizeof(counts));
    statistics_.device_ms += time.device_ms;
    statistics_.rays.primary += counts[COUNTER_PRIMARY];
    statistics_.rays.shadow += counts[COUNTER_SHADOW];
    statistics_.rays.reflection += counts[COUNTER_REFLECTION];
    statistics_.rays.refraction += counts[COUNTER_REFRACTION];
    statistics_.stack_overflows += counts[COUNTER_STACK_OVERFLOWS];
    const std::uint32_t traced = counts[COUNTER_PRIMARY] + counts[COUNTER_REFLECTION] + counts[COUNTER_REFRACTION];
    if (traced >= kTrustedRays) ms_per_ray_ = time.device_ms / traced;
    if (counts[COUNTER_UNFINISHED] > 0 && counts[COUNTER_STUCK] == counts[COUNTER_UNFINISHED]) {
      throw Error(ErrorKind::failed,
                  "a ray in the tile at pixel " + std::to_string(tile.x) + "," + std::to_string(tile.y) +
                      " takes more steps than the driver lets a shader take; try fewer lights or --device");
    }
    return counts[COUNTER_UNFINISHED];
  }

  const GpuScene& scene_;
  Submitter submitter_;
  glm::ivec2 tile_;
  double wanted_ms_;
  Film& film_;
  Buffer counters_, paths_, no_aovs_, dispatch_;
  ComputePipeline pipeline_;
  std::vector<BindingSet> bindings_;
  double ms_per_ray_ = kFirstMsPerRay;  ///< shadow rays included
  TraceStatistics statistics_;
};

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

TraceStatistics trace_film(const Device& device, const GpuScene& scene, SceneLoads loads,
                           const TraceSpecialization& specialization, const RenderSettings& settings,
                           const RenderCallbacks& callbacks, Film& film) {
  Tracer tracer(device, scene, loads, specialization, settings, film);
  const auto start = Clock::now();
  const auto seconds = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };
  const auto stop = [&] { return (callbacks.cancelled && callbacks.cancelled()) || seconds() > settings.time_limit_s; };
  const std::vector<PixelRect> tiles = tracer.tiles();
  const std::vector<SamplePass> passes = schedule_passes(settings.sample_begin, settings.sample_end);
  const double sample_count = static_cast<double>(settings.sample_end - settings.sample_begin);
  bool going = true;
  for (std::size_t p = 0; going && p < passes.size(); ++p) {
    for (std::size_t t = 0; going && t < tiles.size(); ++t) {
      going = tracer.run_tile(tiles[t], passes[p], stop);
      if (!callbacks.progress) continue;
      const double pass_share =
          (passes[p].end - passes[p].begin) * static_cast<double>(t + 1) / static_cast<double>(tiles.size());
      const double done = (passes[p].begin - settings.sample_begin + pass_share) / sample_count;
      callbacks.progress(progress_at(done, tracer.statistics().rays, seconds()));
    }
  }
  TraceStatistics statistics = tracer.statistics();
  statistics.wall_ms = seconds() * 1000.0;
  return statistics;
}

double trace_aovs(const Device& device, const GpuScene& scene, SceneLoads loads,
                  const TraceSpecialization& specialization, Film& film) {
  Submitter submitter(device);
  const Buffer unused(device, 0, BufferUse::storage);
  Buffer dispatch_values = dispatch_buffer(device);
  ComputePipeline pipeline;
  double compile_ms = 0.0;
  for (Film::Band& band : film.bands()) {
    std::vector<Binding> bindings = scene.bindings();
    bindings.insert(bindings.end(), {{BINDING_FILM, &unused},
                                     {BINDING_COUNTERS, &unused},
                                     {BINDING_PATHS, &unused},
                                     {BINDING_AOVS, &band.aovs},
                                     {BINDING_DISPATCH, &dispatch_values}});
    if (compile_ms == 0.0) {
      pipeline = make_trace_pipeline(device, Kernel::primary, loads, specialization, bindings);
      compile_ms = pipeline.compile_ms();
    }
    const BindingSet set(device, pipeline, bindings);
    const PixelRect rows{film.area().x, film.area().y + band.first_row, film.area().width, band.row_count};
    for (const PixelRect& tile : schedule_tiles(rows, glm::ivec2(kGpuTile), rows.height)) {
      set_dispatch(dispatch_values, tile_constants(scene, tile, film.area(), band));
      const Dispatch dispatch = tile_dispatch(pipeline, set, tile);
      submitter.run(std::span(&dispatch, 1));
    }
  }
  return compile_ms;
}

}  // namespace vernier
