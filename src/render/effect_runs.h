#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace vernier {

/// Rays begun at one depth: depth 0 are the camera's.
struct DepthRays {
  std::uint64_t path = 0;    ///< camera rays, or those reflected and refracted so often
  std::uint64_t shadow = 0;  ///< shadow rays from where they ended
};

/// What a pipeline with counters says. Empty vectors: nothing was counted.
struct EffectRuns {
  std::vector<std::uint64_t> searches;  ///< [EFFECT_COUNT] searches in which the effect of that bit ran
  std::vector<DepthRays> by_depth;      ///< [COUNTED_DEPTHS], the last of that depth and all below
};

/// Adds the counters of a dispatch, from COUNTER_EFFECT_RUNS on, to `runs`. No `counters`: nothing is counted, `runs`
/// stays as it is. The camera's rays are not among these counters.
void add_effect_runs(std::span<const std::byte> counters, EffectRuns& runs);

}  // namespace vernier
