#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "render/error_estimate.h"
#include "render/render_statistics.h"

namespace vernier {

/// What tracing took.
struct TraceStatistics {
  RayCounts rays;
  std::uint64_t stack_overflows = 0;
  double device_ms = 0.0;
  double wall_ms = 0.0;
  std::vector<PipelineTime> pipelines;  ///< with the first dispatch, at which some drivers compile
  EffectRuns effect_runs;               ///< empty unless the specialization counts effects
  std::uint64_t device_bytes = 0;       ///< of the buffers that tracing alone needs
  std::optional<ErrorEstimate> error;   ///< with an error target, once there is one
  SavedMemory saved;                    ///< of these buffers
  bool stopped = false;                 ///< by the time limit or the caller, before its end
};

}  // namespace vernier
