#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "effects/effect_set.h"
#include "render/render_settings.h"

namespace vernier {

/// Settings that the sweep measures.
struct CostPoint {
  std::string name;  ///< as people read it: `4 bounces`
  std::string axis;  ///< spp, adaptive, level, bounces, cutoff, filter, effects or spot
  RenderSettings settings;
  std::vector<std::pair<std::string, std::string>> options;  ///< of `vernier render`, without dashes
  bool has_command = true;                                   ///< false: no option of render says it
};

/// What the plan of a sweep follows from.
struct CostPlanInput {
  RenderSettings settings;       ///< of which one is changed at a time; spp are those of all axes but the first
  EffectSet effects;             ///< of those settings
  std::uint32_t most_spp = 256;  ///< of the axis of samples
  double error_at_16 = 0.1;      ///< sqrt(relMSE) of 16 samples, for the targets of adaptive sampling
  bool has_textures = true;      ///< the scene has: else their filter is no axis
  bool with_spots = true;        ///< a level at each spot alone
};

/// The points of a sweep, most telling first: what does not fit into the time is taken from the end.
std::vector<CostPoint> plan_points(const CostPlanInput& input);

/// What a point is expected to take, milliseconds.
struct PointTime {
  double once_ms = 0.0;  ///< compiling
  double run_ms = 0.0;   ///< a run and its comparison
};

/// How many of `points`, from the front, can have `runs` runs each in `budget_ms`; at least 1 of any.
std::size_t points_that_fit(const std::vector<PointTime>& points, int runs, double budget_ms);

/// Samples per pixel of the longest point of the axis of samples: the largest power of two that is at most a sixteenth
/// of the reference's `reference_spp`, so that its own noise is at most a fourth, and takes at most `longest_ms`.
/// At least 4.
std::uint32_t most_spp(std::uint64_t reference_spp, double ms_per_sample, double longest_ms);

}  // namespace vernier
