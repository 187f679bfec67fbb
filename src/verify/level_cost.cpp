#include "verify/level_cost.h"

#include <algorithm>
#include <array>

#include "effects/detect_effects.h"
#include "render/film.h"
#include "render/gpu_scene.h"
#include "render/pack_scene.h"
#include "render/trace_film.h"
#include "shared/accuracy.h"

namespace vernier {
namespace {

/// In the order of SPOT_*.
constexpr std::array kSpotNames{"box", "triangle", "position", "spawn", "fresnel", "specular", "sum"};
static_assert(kSpotNames.size() == SPOT_COUNT);

/// A choice of levels, its own film, and the device time of its last trace.
struct Candidate {
  LevelCost cost;
  Film film;
  FilmTracer tracer;
  double total_ms = 0.0;

  Candidate(LevelCost named, const Device& device, const GpuScene& scene, TraceSpecialization specialization,
            std::uint32_t levels, const RenderSettings& settings)
      : cost(std::move(named)),
        film(device, {0, 0, settings.width, settings.height}, false),
        tracer(device, scene, choose_scene_loads(device.description()), at_levels(specialization, levels), settings,
               film) {}

  static TraceSpecialization at_levels(TraceSpecialization specialization, std::uint32_t levels) {
    specialization.levels = levels;
    return specialization;
  }

  /// Device time of one more trace, in milliseconds.
  double trace_ms() {
    const double before = total_ms;
    total_ms = tracer.trace({}).device_ms;
    return total_ms - before;
  }
};

struct Choice {
  const char* spot;
  const char* level;
  std::uint32_t levels;
};

/// The fast level everywhere, then what is compared with it.
std::vector<Choice> choices() {
  std::vector<Choice> all{{"all", "fast", LEVELS_OF(LEVEL_FAST)}};
  for (const auto& [name, level] : {std::pair{"robust", LEVEL_ROBUST}, std::pair{"exact", LEVEL_EXACT}}) {
    for (std::uint32_t spot = 0; spot < SPOT_COUNT; ++spot)
      all.push_back({kSpotNames[spot], name, level << (2 * spot)});
    all.push_back({"all", name, LEVELS_OF(level)});
  }
  return all;
}

void book(LevelCost& cost, std::vector<double> ratios) {
  std::sort(ratios.begin(), ratios.end());
  cost.ratio = ratios[ratios.size() / 2];
  cost.least = ratios.front();
  cost.most = ratios.back();
}

}  // namespace

std::vector<LevelCost> measure_level_costs(const Device& device, const Scene& scene, const Camera& camera,
                                           const LevelCostSetup& setup) {
  RenderSettings settings;
  settings.width = setup.width;
  settings.height = setup.height;
  settings.sample_end = settings.spp = setup.spp;
  PackedScene packed = pack_scene(scene, 0);
  set_camera(packed, camera, settings);
  set_settings(packed, settings);
  GpuScene gpu_scene(device, packed, choose_scene_loads(device.description()));
  gpu_scene.set_constants(device, packed.constants, packed.steering);
  const EffectSet effects = detect_effects(scene, camera, static_cast<int>(settings.max_bounces));
  const TraceSpecialization specialization =
      specialize(effects.bits, packed.bvh.depth, settings.max_bounces, false, device.description());

  std::vector<std::unique_ptr<Candidate>> candidates;
  for (const Choice& one : choices()) {
    candidates.push_back(std::make_unique<Candidate>(LevelCost{one.spot, one.level}, device, gpu_scene, specialization,
                                                     one.levels, settings));
  }
  std::vector<std::vector<double>> ratios(candidates.size());
  for (int round = 0; round < setup.rounds; ++round) {
    for (std::size_t i = 1; i < candidates.size(); ++i) {
      const double fast_ms = candidates.front()->trace_ms();
      ratios[i].push_back(candidates[i]->trace_ms() / fast_ms);
    }
  }
  std::vector<LevelCost> costs;
  for (std::size_t i = 1; i < candidates.size(); ++i) {
    book(candidates[i]->cost, ratios[i]);
    costs.push_back(candidates[i]->cost);
  }
  return costs;
}

}  // namespace vernier
