#include "accuracy/sweep.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <memory>
#include <tuple>

#include "effects/choose_effects.h"
#include "error.h"
#include "math/elapsed.h"
#include "render/timed_trace.h"

namespace vernier {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kReferenceShare = 0.3;
/// Of the budget: what the estimate of the rest is off by.
constexpr double kPlannedShare = 0.85;
constexpr int kLeastRuns = 4;  // two pairs for the floor
constexpr int kMostRuns = 16;

/// Scene, pipelines and films of a sweep.
class Bench {
 public:
  Bench(const Device& device, const Scene& scene, const Camera& camera, const SweepSetup& setup)
      : setup_(setup),
        effects_(plan_effects(scene, camera, setup.settings.max_bounces, 0.0, "auto")),
        plan_(choose_effects(effects_, setup.settings.effects)),
        staged_(device, scene, camera, setup.settings) {
    sweep_.build_ms = staged_.packed().bake_ms + staged_.packed().bvh_build_ms;
    sweep_.upload_ms = std::max(0.0, ms_since(start_) - sweep_.build_ms);
  }

  Sweep run() {
    const double pilot_ms = time_pilot();
    make_reference(pilot_ms);
    choose_points(pilot_ms);
    run_rounds();
    sweep_.seconds = ms_since(start_) / 1000.0;
    return std::move(sweep_);
  }

 private:
  double left_ms() const { return setup_.budget_s * 1000.0 - ms_since(start_); }
  bool is_stopped() const { return setup_.stop && setup_.stop(); }

  void tell(std::string_view work) const {
    if (setup_.progress) setup_.progress(std::min(1.0, ms_since(start_) / (setup_.budget_s * 1000.0)), work);
  }

  /// is_stopped, which a trace asks between its dispatches, that tells of the work as well.
  std::function<bool()> telling(std::string_view work) const {
    return [this, work] {
      tell(work);
      return is_stopped();
    };
  }

  TraceSpecialization specialization(const RenderSettings& settings) const {
    TraceSpecialization values = staged_.specialization(choose_effects(effects_, settings.effects).bits);
    // One pipeline for all numbers of bounces: the deepest's room for waiting rays.
    const std::uint32_t deepest = std::max(settings.max_bounces, setup_.settings.max_bounces);
    values.path_stack = waiting_rays(values.effects, deepest);
    values.levels = levels_of(settings);
    values.listed_pixels = settings.error_target.has_value();
    return values;
  }

  /// The pipeline for `settings`, compiled when it is asked for first.
  TimedTrace& trace_of(const RenderSettings& settings) {
    const TraceSpecialization values = specialization(settings);
    const Key key{values.effects, values.levels, values.path_stack, values.listed_pixels};
    std::unique_ptr<TimedTrace>& trace = traces_[key];
    if (!trace) trace = std::make_unique<TimedTrace>(staged_, values, settings);
    return *trace;
  }

  /// Compiles the base pipeline, and returns the time of a sample of every pixel.
  double time_pilot() {
    RenderSettings settings = setup_.settings;
    settings.sample_end = settings.spp = 16;
    const auto start = Clock::now();
    TimedTrace& trace = trace_of(settings);
    compile_ms_ = ms_since(start);
    staged_.set_settings(settings);
    trace.trace_anew(settings, telling("first picture"));
    pilot_ = trace.picture();
    return trace.trace_anew(settings, telling("first picture")).wall_ms / 16.0;
  }

  void make_reference(double ms_per_sample) {
    if (setup_.truth) {
      ConvergedReference& reference = sweep_.reference;
      reference.image = reference.halves[0] = reference.halves[1] = *setup_.truth;
      reference.file = setup_.truth_file;
    } else {
      const double budget_ms = kReferenceShare * setup_.budget_s * 1000.0;
      const RenderSettings settings = reference_settings(setup_.settings, choose_part_spp(budget_ms, ms_per_sample));
      const ReferenceRun run{budget_ms, [this] { tell("reference"); }, telling("reference")};
      sweep_.reference = render_reference_parts(staged_, trace_of(settings), settings, run);
    }
  }

  void choose_points(double ms_per_sample) {
    const auto start = Clock::now();
    const ErrorFigures figures = error_figures(pilot_, sweep_.reference.image, flip(sweep_.reference.image, pilot_));
    const double compare_ms = ms_since(start);
    constexpr double kLongestShare = 0.05;  // of the budget, for a run of the longest point
    constexpr std::uint64_t kAnyNumber = 1u << 20;
    CostPlanInput input{setup_.settings, plan_, 0, figures.rel_error, !staged_.packed().textures.empty(),
                        !setup_.quick};
    input.most_spp = most_spp(setup_.truth ? kAnyNumber : sweep_.reference.spp, ms_per_sample,
                              kLongestShare * setup_.budget_s * 1000.0 / kLeastRuns);
    const std::vector<CostPoint> points = plan_points(input);
    std::vector<PointTime> times;
    for (const CostPoint& point : points)
      times.push_back(expected(point, ms_per_sample, compare_ms, figures.rel_error));
    const std::size_t count = points_that_fit(times, kLeastRuns, kPlannedShare * left_ms());
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (i < count) {
        sweep_.points.emplace_back().point = points[i];
      } else {
        sweep_.left_out.push_back(points[i].name);
      }
    }
  }

  PointTime expected(const CostPoint& point, double ms_per_sample, double compare_ms, double error_at_16) const {
    double samples = point.settings.spp;
    if (point.settings.error_target) samples = 16.0 * std::pow(error_at_16 / *point.settings.error_target, 2.0);
    const bool shares_pipeline =
        point.axis == "spp" || point.axis == "bounces" || point.axis == "cutoff" || point.axis == "filter";
    // Two times what a sample takes: listed pixels and the exact level are slower.
    const double slower = shares_pipeline ? 1.0 : 2.0;
    return {shares_pipeline ? 0.0 : compile_ms_, slower * samples * ms_per_sample + compare_ms};
  }

  void run_rounds() {
    for (int round = 0; round < kMostRuns; ++round) {
      const auto start = Clock::now();
      for (PointResult& result : sweep_.points) {
        if (is_stopped()) break;
        run_point(result, setup_.settings.seed + static_cast<std::uint32_t>(round));
        tell("round " + std::to_string(round + 1));
      }
      if (is_stopped()) {
        drop_unfinished();
        return;
      }
      // A pair of rounds more has to fit.
      const bool enough = round % 2 == 1 && left_ms() < 2.0 * ms_since(start);
      if (enough) return;
    }
  }

  /// Keeps the points that have two runs at least.
  void drop_unfinished() {
    const auto is_unfinished = [](const PointResult& result) { return result.runs.size() < 2; };
    for (const PointResult& result : sweep_.points) {
      if (is_unfinished(result)) sweep_.left_out.push_back(result.point.name);
    }
    std::erase_if(sweep_.points, is_unfinished);
    sweep_.complete = false;
  }

  void run_point(PointResult& result, std::uint32_t seed) {
    RenderSettings settings = result.point.settings;
    settings.seed = seed;
    TimedTrace& trace = trace_of(settings);
    staged_.set_settings(settings);
    if (result.runs.empty()) trace.trace_anew(settings, setup_.stop);  // warms caches up, not counted
    const TraceTime time = trace.trace_anew(settings, setup_.stop);
    if (is_stopped()) return;  // within the run
    const DevelopedFilm developed = trace.developed();
    const Image picture{settings.width, settings.height, 4, developed.color};
    const FlipError map = flip(sweep_.reference.image, picture);
    result.compile_ms = trace.compile_ms();
    result.runs.push_back({seed, time.device_ms, time.wall_ms, developed.mean_samples, total(time.rays),
                           error_figures(picture, sweep_.reference.image, map)});
    if (result.runs.size() == 1) {
      result.first_picture = picture;
      result.first_map = map;
    }
    note_bias(result, picture);
  }

  /// A product for each second run with the one before it.
  void note_bias(PointResult& result, const Image& picture) {
    Image& before = before_[result.point.name];
    if (result.runs.size() % 2 == 0) {
      const ConvergedReference& reference = sweep_.reference;
      result.bias_products.push_back(bias_product(before, picture, reference.halves[0], reference.halves[1]));
    } else {
      before = picture;
    }
  }

  using Key = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, bool>;

  Clock::time_point start_ = Clock::now();
  const SweepSetup& setup_;
  EffectSet effects_;  ///< as detected; what any point asks for, whatever its cutoff
  EffectSet plan_;     ///< of the settings
  StagedScene staged_;
  std::map<Key, std::unique_ptr<TimedTrace>> traces_;
  std::map<std::string, Image> before_;  ///< by the point's name
  double compile_ms_ = 0.0;
  Image pilot_;
  Sweep sweep_;
};

}  // namespace

Sweep measure_costs(const Device& device, const Scene& scene, const Camera& camera, const SweepSetup& setup) {
  const Image* truth = setup.truth ? &*setup.truth : nullptr;
  if (truth && (truth->width != setup.settings.width || truth->height != setup.settings.height)) {
    throw Error(ErrorKind::usage, "--reference: it has " + std::to_string(truth->width) + "x" +
                                      std::to_string(truth->height) + " pixels; give them as --size");
  }
  return Bench(device, scene, camera, setup).run();
}

}  // namespace vernier
