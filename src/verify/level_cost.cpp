#include "verify/level_cost.h"

#include <array>
#include <memory>

#include "effects/detect_effects.h"
#include "render/timed_trace.h"
#include "shared/accuracy.h"

namespace vernier {
namespace {

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

}  // namespace

std::vector<LevelCost> measure_level_costs(const Device& device, const Scene& scene, const Camera& camera,
                                           const LevelCostSetup& setup) {
  RenderSettings settings;
  settings.width = setup.width;
  settings.height = setup.height;
  settings.sample_end = settings.spp = setup.spp;
  const EffectSet effects = detect_effects(scene, camera, static_cast<int>(settings.max_bounces));
  const StagedScene staged(device, scene, camera, settings);
  TraceSpecialization specialization = staged.specialization(effects.bits);

  const std::vector<Choice> all = choices();
  std::vector<std::unique_ptr<TimedTrace>> candidates;
  for (const Choice& one : all) {
    specialization.levels = one.levels;
    candidates.push_back(std::make_unique<TimedTrace>(staged, specialization, settings));
  }
  std::vector<std::vector<double>> ratios(candidates.size());
  for (int round = 0; round < setup.rounds; ++round) {
    for (std::size_t i = 1; i < candidates.size(); ++i) {
      const double fast_ms = candidates.front()->trace().device_ms;
      ratios[i].push_back(candidates[i]->trace().device_ms / fast_ms);
    }
  }
  std::vector<LevelCost> costs;
  for (std::size_t i = 1; i < candidates.size(); ++i) {
    costs.push_back({all[i].spot, all[i].level, spread_of(ratios[i])});
  }
  return costs;
}

}  // namespace vernier
