#pragma once

#include <functional>
#include <optional>

#include "render/error_estimate.h"
#include "render/tile_tracer.h"

namespace vernier {

/// How far an adaptive trace is: the share of the work, in [0, 1].
using AdaptiveProgress = std::function<void(double share)>;

/// Traces into `film` until sqrt(relMSE) lies below settings.error_target with 95 % confidence, or every pixel that
/// needs more has settings.spp samples. All pixels get 8 samples; then blocks of 8x8 pixels get twice their samples,
/// those first whose error falls most for each ray (ErrorMap). What is decided follows from whole rounds over the
/// image: not from tiles or time. Stops early when `stop` says so. The estimate of the last whole round; none before
/// there were two.
std::optional<ErrorEstimate> trace_to_target(const Device& device, TileTracer& tracer, const Film& film,
                                             const RenderSettings& settings, const std::function<bool()>& stop,
                                             const AdaptiveProgress& progress);

}  // namespace vernier
