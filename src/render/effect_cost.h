#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "effects/effect_set.h"
#include "gpu/device.h"
#include "math/spread.h"
#include "render/timed_trace.h"
#include "scene/scene.h"

namespace vernier {

/// What one effect costs and shows: the frame with all effects of a plan against the frame without this one, and
/// without those that do nothing without it.
struct EffectCost {
  std::uint32_t bit = 0;
  std::uint32_t without = 0;  ///< all bits that were left out
  std::int64_t rays = 0;      ///< rays saved; below 0 where the others trace more without it
  Spread ratio;               ///< device time without it to that with it
  double rmse = 0.0;          ///< of the picture without it, linear
  double flip_mean = 0.0;
};

/// Whether some rounds were quicker with the effect and some without, so that its time is not known.
inline bool is_noise(const Spread& ratio) {
  return ratio.least < 1.0 && ratio.most > 1.0;
}

/// What one more bounce adds to the frame.
struct BounceCost {
  std::uint32_t depth = 0;  ///< of its rays; 0: camera rays and their shadow rays
  std::uint64_t rays = 0;
  double ms = 0.0;  ///< median of the differences; noise can take it below 0
};

/// Where the time of a frame goes.
struct EffectLedger {
  double frame_ms = 0.0;            ///< device time with the plan's effects, median
  RayCounts rays;                   ///< of that frame
  SavedMemory saved;                ///< of that frame
  Spread all;                       ///< device time with every effect there is to that with the plan's
  std::vector<EffectCost> effects;  ///< of those that are on, in bit order
  std::vector<BounceCost> bounces;  ///< until a bounce adds no ray, 16 at most
  bool complete = true;             ///< false: stopped before all were measured
};

/// How measure_effect_costs goes about it.
struct EffectCostSetup {
  int rounds = 5;                        ///< pairs of traces for each effect, at least 1
  std::function<void(double)> progress;  ///< share done; may be empty
  std::function<bool()> stop;            ///< true: return what is measured; may be empty
};

/// Measures the frame that `settings` describe, of `scene`, which has passed validate_scene, with the effects of
/// `plan`, and again without each of them: both traced in turn, a pair a round. settings.effects is not looked at.
/// Throws Error as a render does.
EffectLedger measure_effect_costs(const Device& device, const Scene& scene, const Camera& camera,
                                  const RenderSettings& settings, const EffectSet& plan, const EffectCostSetup& setup);

}  // namespace vernier
