#include "render/effect_cost.h"

#include <algorithm>
#include <bit>

#include "effects/choose_effects.h"
#include "image/difference.h"
#include "image/flip.h"

namespace vernier {
namespace {

constexpr std::uint32_t kEveryEffect = (1u << EFFECT_COUNT) - 1;
/// Between mirrors, rays go on for as long as they are let; what is deeper than that is weak, and costs the same again.
constexpr std::uint32_t kDeepestTimed = 16;

/// The frame of a plan and what it is compared with.
class Bench {
 public:
  Bench(const Device& device, const Scene& scene, const Camera& camera, const RenderSettings& settings,
        const EffectSet& plan, int rounds)
      : settings_(settings),
        bounces_(plan.depth.bounces),
        rounds_(rounds),
        scene_(device, scene, camera, settings),
        frame_(scene_, lean(plan.bits), settings) {
    const TraceTime first = trace_to(bounces_);  // warms caches up and is not timed
    rays_ = first.rays;
    saved_ = first.saved;
    picture_ = frame_.picture();
  }

  const RayCounts& rays() const { return rays_; }
  const SavedMemory& saved() const { return saved_; }
  double frame_ms() const { return spread_of(frame_ms_).median; }

  /// Device time of `other` to the frame's.
  Spread ratio_of(TimedTrace& other) {
    std::vector<double> ratios;
    for (int round = 0; round < rounds_; ++round) {
      frame_ms_.push_back(frame_.trace().device_ms);
      ratios.push_back(other.trace().device_ms / frame_ms_.back());
    }
    return spread_of(std::move(ratios));
  }

  Spread ratio_of_all() {
    TimedTrace all(scene_, scene_.specialization(kEveryEffect), settings_);
    all.trace();
    return ratio_of(all);
  }

  EffectCost cost_without(std::uint32_t bit, std::uint32_t effects, std::uint32_t left_out) {
    EffectCost cost;
    cost.bit = bit;
    cost.without = left_out;
    TimedTrace other(scene_, lean(effects & ~left_out), settings_);
    cost.rays = static_cast<std::int64_t>(total(rays_)) - static_cast<std::int64_t>(total(other.trace().rays));
    const Image picture = other.picture();
    cost.rmse = compare_images(picture, picture_).rmse;
    cost.flip_mean = flip(picture_, picture).mean;
    cost.ratio = ratio_of(other);
    return cost;
  }

  /// One bounce more at a time, with the frame's own pipeline.
  std::vector<BounceCost> bounces() {
    std::vector<BounceCost> costs;
    std::uint64_t before = 0;
    for (std::uint32_t depth = 0; depth <= std::min(bounces_, kDeepestTimed); ++depth) {
      const std::uint64_t rays = total(trace_to(depth).rays);
      if (rays == before) break;
      costs.push_back({depth, rays - before, added_ms(depth)});
      before = rays;
    }
    set_bounces(bounces_);
    return costs;
  }

 private:
  /// As a render specializes: no place on the stack for rays that are deeper than any can be.
  TraceSpecialization lean(std::uint32_t effects) const {
    TraceSpecialization values = scene_.specialization(effects);
    values.path_stack = waiting_rays(effects, bounces_);
    return values;
  }

  void set_bounces(std::uint32_t depth) {
    RenderSettings settings = settings_;
    settings.max_bounces = depth;
    scene_.set_settings(settings);
  }

  TraceTime trace_to(std::uint32_t depth) {
    set_bounces(depth);
    return frame_.trace();
  }

  /// Median of what rays of `depth` add to the device time.
  double added_ms(std::uint32_t depth) {
    std::vector<double> ms;
    for (int round = 0; round < rounds_; ++round) {
      const double shallower = depth == 0 ? 0.0 : trace_to(depth - 1).device_ms;
      ms.push_back(trace_to(depth).device_ms - shallower);
    }
    return spread_of(std::move(ms)).median;
  }

  RenderSettings settings_;
  std::uint32_t bounces_;
  int rounds_;
  StagedScene scene_;
  TimedTrace frame_;
  RayCounts rays_;
  SavedMemory saved_;
  Image picture_;
  std::vector<double> frame_ms_;
};

/// What leaving out the one effect `bit` takes from the plan.
std::uint32_t left_out_with(const EffectSet& plan, const EffectReason& effect) {
  return plan.bits & ~choose_effects(plan, "auto,-" + effect.name).bits;
}

}  // namespace

EffectLedger measure_effect_costs(const Device& device, const Scene& scene, const Camera& camera,
                                  const RenderSettings& settings, const EffectSet& plan, const EffectCostSetup& setup) {
  const double steps = std::popcount(plan.bits) + 2.0;
  double done = 0.0;
  EffectLedger ledger;
  const auto goes_on = [&] {
    if (setup.progress) setup.progress(++done / steps);
    ledger.complete = !setup.stop || !setup.stop();
    return ledger.complete;
  };
  Bench bench(device, scene, camera, settings, plan, setup.rounds);
  ledger.rays = bench.rays();
  ledger.saved = bench.saved();
  ledger.all = bench.ratio_of_all();
  if (goes_on()) ledger.bounces = bench.bounces();
  for (const EffectReason& effect : plan.reasons) {
    if (!effect.on) continue;
    if (!ledger.complete || !goes_on()) break;
    ledger.effects.push_back(bench.cost_without(effect.bit, plan.bits, left_out_with(plan, effect)));
  }
  ledger.frame_ms = bench.frame_ms();
  return ledger;
}

}  // namespace vernier
