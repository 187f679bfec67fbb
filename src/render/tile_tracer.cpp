#include "render/tile_tracer.h"

#include <algorithm>
#include <array>
#include <thread>

#include "error.h"
#include "render/tile_dispatch.h"
#include "render/tile_schedule.h"
#include "shared/bindings.h"
#include "shared/film_layout.h"

namespace vernier {
namespace {

/// Invocations per dispatch, in workgroups of kWorkgroup. They take jobs until none is left, so a CPU needs no more
/// than keep its threads busy: each costs the loading and saving of a path.
constexpr std::uint32_t kCpuInvocationsPerThread = 256;
constexpr std::uint32_t kGpuInvocations = 1u << 17;
constexpr std::uint32_t kWorkgroup = 64;
/// Taken for the time of a search until a dispatch of at least kTrustedSearches has been timed: a slow CPU.
constexpr double kFirstMsPerSearch = 1e-3;
constexpr std::uint32_t kTrustedSearches = 1024;
/// Searches that an invocation may make, over its even share of a dispatch: a thread that is faster takes more jobs.
constexpr double kBudgetShare = 2.0;

std::uint64_t bytes_per_sample(bool count_cost) {
  return SAMPLE_BLOCKS(count_cost) * 16;
}

/// What the settings ask for, but no larger than the image nor than a pass allows.
glm::ivec2 chosen_tile(const RenderSettings& settings, int side, const PixelRect& area, std::uint64_t sample_bytes) {
  const glm::ivec2 tile = settings.tile.x > 0 ? settings.tile : glm::ivec2(side);
  return fitting_tile(glm::min(tile, glm::ivec2(area.width, area.height)), sample_bytes);
}

std::uint32_t samples_per_pass(const RenderSettings& settings, glm::ivec2 tile, std::uint64_t sample_bytes) {
  const auto fitting = static_cast<std::uint32_t>(kMostPassBytes / (jobs_per_sample(tile) * sample_bytes));
  return std::min({fitting, kMostSamplesPerPass, settings.sample_end - settings.sample_begin});
}

/// Size of the buffer for a pass of a tile.
std::uint64_t pass_bytes(const RenderSettings& settings, glm::ivec2 tile, std::uint64_t sample_bytes) {
  return jobs_per_sample(tile) * sample_bytes * samples_per_pass(settings, tile, sample_bytes);
}

std::uint64_t path_bytes(std::uint32_t invocations, std::uint32_t path_stack) {
  return std::uint64_t{invocations} * PATH_BLOCKS(path_stack) * 16;
}

/// As many as suit the device, but no more than its largest buffer has room for their paths.
std::uint32_t invocation_count(const DeviceDescription& device, std::uint32_t path_stack) {
  const std::uint32_t threads = std::max(std::thread::hardware_concurrency(), 1u);
  const std::uint32_t wanted = device.is_cpu ? kCpuInvocationsPerThread * threads : kGpuInvocations;
  const std::uint64_t most = std::min(device.max_storage_buffer_range_bytes, device.max_allocation_bytes);
  const std::uint64_t groups = most / path_bytes(kWorkgroup, path_stack);
  return static_cast<std::uint32_t>(std::clamp<std::uint64_t>(groups, 1, wanted / kWorkgroup)) * kWorkgroup;
}

}  // namespace

std::uint64_t tracing_bytes(const RenderSettings& settings, const DeviceDescription& device) {
  const std::uint64_t sample_bytes = bytes_per_sample(wants_aov(settings, "cost"));
  const glm::ivec2 tile = chosen_tile(settings, tile_side(device.is_cpu), image_area(settings), sample_bytes);
  return path_bytes(invocation_count(device, 0), 0) + pass_bytes(settings, tile, sample_bytes);
}

TileTracer::TileTracer(const Device& device, const GpuScene& scene, SceneLoads loads,
                       const TraceSpecialization& specialization, const RenderSettings& settings, Film& film)
    : scene_(scene),
      submitter_(device),
      sample_bytes_(bytes_per_sample(specialization.count_cost)),
      tile_side_(tile_side(device.description().is_cpu)),
      tile_(chosen_tile(settings, tile_side_, film.area(), sample_bytes_)),
      most_samples_(samples_per_pass(settings, tile_, sample_bytes_)),
      wanted_ms_(settings.dispatch_ms),
      invocations_(invocation_count(device.description(), specialization.path_stack)),
      film_(film),
      counters_(device, (specialization.count_effects ? COUNTER_COUNT_WITH_RUNS : COUNTER_COUNT) * 4,
                BufferUse::storage),
      paths_(device, path_bytes(invocations_, specialization.path_stack), BufferUse::storage),
      samples_(device, pass_bytes(settings, tile_, sample_bytes_), stored_use(film_loads(device.description()))),
      pixels_(device, specialization.listed_pixels ? std::uint64_t{4} * tile_.x * tile_.y : 0, BufferUse::storage),
      dispatch_(dispatch_buffer(device)),
      ms_per_search_(kFirstMsPerSearch) {
  std::vector<Binding> bindings = scene.bindings();
  bindings.insert(bindings.end(), {{BINDING_COUNTERS, &counters_},
                                   {BINDING_PATHS, &paths_},
                                   {BINDING_DISPATCH, &dispatch_},
                                   {BINDING_SAMPLES, &samples_},
                                   {BINDING_PIXELS, &pixels_}});
  trace_ = make_trace_pipeline(device, Kernel::trace, loads, specialization, bindings);
  trace_bindings_ = BindingSet(device, trace_, bindings);
  bind_accumulate(device, specialization);
  statistics_.pipelines = {
      {"trace", trace_.compile_ms()}, {"accumulate", accumulate_.compile_ms()}, {"first dispatch", warm_up()}};
  statistics_.device_bytes =
      counters_.size_bytes() + paths_.size_bytes() + samples_.size_bytes() + pixels_.size_bytes();
  note_saved(settings);
}

/// Compiles the accumulate kernel and binds it to each band of the film.
void TileTracer::bind_accumulate(const Device& device, const TraceSpecialization& specialization) {
  const SceneLoads loads = film_loads(device.description());
  for (Film::Band& band : film_.bands()) {
    std::vector<Binding> bindings = {{BINDING_FILM, &band.sums},
                                     {BINDING_COUNTERS, &counters_},
                                     {BINDING_DISPATCH, &dispatch_},
                                     {BINDING_SAMPLES, &samples_},
                                     {BINDING_PIXELS, &pixels_}};
    if (loads == SceneLoads::texels) {
      bindings.insert(bindings.end(),
                      {{BINDING_FILM_TEXELS, &band.sums, true}, {BINDING_SAMPLE_TEXELS, &samples_, true}});
    }
    if (accumulate_bindings_.empty()) {
      accumulate_ = make_trace_pipeline(device, Kernel::accumulate, loads, specialization, bindings);
    }
    accumulate_bindings_.emplace_back(device, accumulate_, bindings);
  }
}

bool TileTracer::run_tile(const PixelRect& tile, const SamplePass& pass, const std::function<bool()>& stop) {
  const std::uint64_t jobs = jobs_per_sample({tile.width, tile.height}) * pass.length();
  return run_jobs(pass_constants(tile, pass), jobs, tile_dispatch(accumulate_, accumulate_bindings(tile), tile), stop);
}

bool TileTracer::run_pixels(const PixelRect& tile, std::span<const std::uint32_t> pixels, const SamplePass& pass,
                            const std::function<bool()>& stop) {
  pixels_.upload(submitter_.device(), std::as_bytes(pixels));
  DispatchConstants constants = pass_constants(tile, pass);
  constants.pixel_count = static_cast<std::uint32_t>(pixels.size());
  const Dispatch accumulate = {.pipeline = &accumulate_,
                               .bindings = &accumulate_bindings(tile),
                               .push_constants = {},
                               .group_count_x = (constants.pixel_count + kWorkgroup - 1) / kWorkgroup,
                               .group_count_y = 1,
                               .group_count_z = 1};
  return run_jobs(constants, std::uint64_t{constants.pixel_count} * pass.length(), accumulate, stop);
}

std::uint32_t TileTracer::samples_of_pass(std::size_t pixels) const {
  return listed_samples(samples_.size_bytes() / sample_bytes_, pixels);
}

const BindingSet& TileTracer::accumulate_bindings(const PixelRect& tile) const {
  return accumulate_bindings_[static_cast<std::size_t>((tile.y - film_.area().y) / film_.band_height())];
}

DispatchConstants TileTracer::pass_constants(const PixelRect& tile, const SamplePass& pass) {
  const auto band = static_cast<std::size_t>((tile.y - film_.area().y) / film_.band_height());
  DispatchConstants constants = tile_constants(scene_, tile, film_.area(), film_.bands()[band]);
  constants.sample_begin = pass.begin;
  constants.sample_end = pass.end;
  return constants;
}

/// Dispatches until all `jobs` are done; `accumulate`, which adds them to the film, follows where none is left for
/// later.
bool TileTracer::run_jobs(DispatchConstants constants, std::uint64_t jobs, const Dispatch& accumulate,
                          const std::function<bool()>& stop) {
  const auto invocations = static_cast<std::uint32_t>(std::min<std::uint64_t>(invocations_, jobs));
  const Dispatch trace = {.pipeline = &trace_,
                          .bindings = &trace_bindings_,
                          .push_constants = {},
                          .group_count_x = (invocations + kWorkgroup - 1) / kWorkgroup,
                          .group_count_y = 1,
                          .group_count_z = 1};
  std::uint32_t counts[COUNTER_COUNT] = {};
  do {
    if (stop()) return false;
    const RayCounts& rays = statistics_.rays;
    const std::uint64_t left = jobs - counts[COUNTER_NEXT_JOB];
    const std::uint64_t taken = choose_jobs(wanted_ms_ / ms_per_search_, rays.primary, total(rays), left);
    constants.job_end = counts[COUNTER_NEXT_JOB] + static_cast<std::uint32_t>(taken);
    constants.search_budget = choose_search_budget(kBudgetShare * wanted_ms_, ms_per_search_, invocations);
    constants.search_limit = search_limit(constants.search_budget);
    run(taken < left ? std::vector{trace} : std::vector{trace, accumulate}, constants, counts);
    constants.resume = 1;
  } while (counts[COUNTER_UNFINISHED] > 0 || counts[COUNTER_NEXT_JOB] < jobs);
  return true;
}

/// What the pipeline with every effect and the cost would have taken beyond this one's buffers.
void TileTracer::note_saved(const RenderSettings& settings) {
  const std::uint32_t full_stack = waiting_rays(~0u, settings.max_bounces);
  const std::uint64_t with_cost = bytes_per_sample(true);
  const std::uint64_t full_pass =
      pass_bytes(settings, chosen_tile(settings, tile_side_, film_.area(), with_cost), with_cost);
  statistics_.saved.path_stack_bytes = path_bytes(invocations_, full_stack) - paths_.size_bytes();
  statistics_.saved.sample_cost_bytes = full_pass - std::min(full_pass, samples_.size_bytes());
}

/// Dispatches both kernels on no job: llvmpipe compiles at the first dispatch, for up to a second. Returns the time.
double TileTracer::warm_up() {
  const PixelRect nothing{film_.area().x, film_.area().y, 0, 0};
  const DispatchConstants constants = tile_constants(scene_, nothing, film_.area(), film_.bands().front());
  const Dispatch trace{.pipeline = &trace_, .bindings = &trace_bindings_, .push_constants = {}};
  const Dispatch accumulate{.pipeline = &accumulate_, .bindings = &accumulate_bindings_.front(), .push_constants = {}};
  return submitter_.run(std::array{trace, accumulate}, {{upload_of(dispatch_, constants)}, {}}).wall_ms;
}

/// Runs `dispatches`, of which the first traces, and books what it did. `counts`: of the dispatch before, replaced by
/// its own.
void TileTracer::run(std::span<const Dispatch> dispatches, const DispatchConstants& constants,
                     std::uint32_t (&counts)[COUNTER_COUNT]) {
  std::vector<std::uint32_t> counters(counters_.size_bytes() / sizeof(std::uint32_t));
  counters[COUNTER_NEXT_JOB] = counts[COUNTER_NEXT_JOB];
  const auto bytes = std::as_writable_bytes(std::span(counters));
  const SubmissionTime time =
      submitter_.run(dispatches, {{upload_of(dispatch_, constants), {&counters_, bytes}}, {{&counters_, bytes}}});
  std::copy_n(counters.begin(), COUNTER_COUNT, counts);
  // Whoever asked in vain counted too.
  counts[COUNTER_NEXT_JOB] = std::min(counts[COUNTER_NEXT_JOB], constants.job_end);
  add_effect_runs(bytes.subspan(sizeof(counts)), statistics_.effect_runs);
  statistics_.device_ms += time.device_ms;
  statistics_.rays.primary += counts[COUNTER_PRIMARY];
  statistics_.rays.shadow += counts[COUNTER_SHADOW];
  statistics_.rays.reflection += counts[COUNTER_REFLECTION];
  statistics_.rays.refraction += counts[COUNTER_REFRACTION];
  statistics_.stack_overflows += counts[COUNTER_STACK_OVERFLOWS];
  const std::uint32_t searches =
      counts[COUNTER_PRIMARY] + counts[COUNTER_SHADOW] + counts[COUNTER_REFLECTION] + counts[COUNTER_REFRACTION];
  if (searches >= kTrustedSearches) ms_per_search_ = time.device_ms / searches;
  if (counts[COUNTER_UNFINISHED] > 0 && counts[COUNTER_STUCK] == counts[COUNTER_UNFINISHED]) {
    throw Error(ErrorKind::failed, "a ray in the tile at pixel " + std::to_string(constants.tile_x) + "," +
                                       std::to_string(constants.tile_y) +
                                       " takes more steps than the driver lets a shader take; try --device");
  }
}

}  // namespace vernier
