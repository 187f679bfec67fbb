#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "render/error_estimate.h"
#include "render/error_map.h"
#include "render/tile_tracer.h"

namespace vernier {

/// Where a trace to a target stands. The first two rounds take samples of every pixel, later ones of the blocks that
/// `errors` choose.
struct AdaptivePosition {
  ErrorMap errors;                ///< after the last whole round
  std::uint32_t round = 0;        ///< that is being traced
  std::uint32_t passes_done = 0;  ///< of that round: over a tile's pixels of equal sample count
};

/// What a trace to a target asks and tells its caller.
struct AdaptiveCallbacks {
  std::function<bool()> stop;
  std::function<void(double share)> progress;  ///< of the work, in [0, 1]; after a round
  std::function<void()> after_pass;            ///< the position holds, with what is in the film
};

/// Traces into `film` until sqrt(relMSE) lies below settings.error_target with 95 % confidence, or every pixel that
/// needs more has settings.spp samples. All pixels get 8 samples; then blocks of 8x8 pixels get twice their samples,
/// those first whose error falls most for each ray (ErrorMap). What is decided follows from whole rounds over the
/// image: not from tiles or time. Goes on from `position`, whose samples are in the film, and leaves there how far it
/// came: stops early when `stop` says so.
void trace_to_target(const Device& device, TileTracer& tracer, const Film& film, const RenderSettings& settings,
                     AdaptivePosition& position, const AdaptiveCallbacks& callbacks);

/// The estimate of the last whole round; none before there were two.
std::optional<ErrorEstimate> estimate_at(const AdaptivePosition& position);

/// The share of the work that is done, in [0, 1]: the square of the error falls like the reciprocal of the work, or
/// faster.
double share_at(const AdaptivePosition& position, double target);

}  // namespace vernier
