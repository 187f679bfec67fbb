#pragma once

#include <string>
#include <vector>

#include "gpu/device.h"
#include "math/spread.h"
#include "scene/scene.h"

namespace vernier {

/// What a level costs at one spot: the time of a picture that takes it there, against the fast level everywhere.
struct LevelCost {
  std::string spot;   ///< "box", "triangle", ..., or "all" for every spot
  std::string level;  ///< "robust" or "exact"
  Spread ratio;       ///< of device times, over the rounds
};

/// The picture and the rounds that measure_level_costs takes.
struct LevelCostSetup {
  int width = 384;
  int height = 216;
  std::uint32_t spp = 2;
  int rounds = 7;  ///< at least 1
};

/// Times `scene`, which has passed validate_scene, through `camera` at robust and exact, at each spot alone and at all
/// of them, each time right after the fast level: a busy machine slows both. Pipelines are compiled once, before the
/// clock starts. Throws Error like a render.
std::vector<LevelCost> measure_level_costs(const Device& device, const Scene& scene, const Camera& camera,
                                           const LevelCostSetup& setup);

}  // namespace vernier
