#include "render/adaptive_trace.h"

#include <algorithm>
#include <map>
#include <vector>

#include "render/develop.h"

namespace vernier {
namespace {

/// Samples of every pixel in the first round; the second doubles them. Fewer see too little of small things.
constexpr std::uint32_t kFirstSamples = 4;

/// Blocks that have so many samples.
using BlocksBySamples = std::map<std::uint32_t, std::vector<std::uint32_t>>;

/// What run_pixels() wants to know of the pixels of `blocks` that lie in `tile`, both counted in pixels of the film.
std::vector<std::uint32_t> listed_pixels(const ErrorMap& errors, const std::vector<std::uint32_t>& blocks,
                                         const PixelRect& tile) {
  std::vector<std::uint32_t> pixels;
  for (const std::uint32_t number : blocks) {
    const PixelRect block = errors.block(number);
    const int right = std::min(block.x + block.width, tile.x + tile.width);
    const int bottom = std::min(block.y + block.height, tile.y + tile.height);
    for (int y = std::max(block.y, tile.y); y < bottom; ++y) {
      for (int x = std::max(block.x, tile.x); x < right; ++x) {
        pixels.push_back(static_cast<std::uint32_t>(y - tile.y) << 16 | static_cast<std::uint32_t>(x - tile.x));
      }
    }
  }
  return pixels;
}

/// One trace to a target.
class AdaptiveTrace {
 public:
  AdaptiveTrace(TileTracer& tracer, const Film& film, const RenderSettings& settings, AdaptivePosition& position,
                const AdaptiveCallbacks& callbacks)
      : tracer_(tracer),
        settings_(settings),
        position_(position),
        callbacks_(callbacks),
        area_(film.area()),
        tiles_(tracer.tiles(area_)) {}

  /// What the round samples; nothing where the target is reached.
  std::vector<std::uint32_t> blocks() const {
    return position_.round < 2 ? position_.errors.all_blocks()
                               : position_.errors.choose_blocks(settings_.error_target.value(), settings_.spp);
  }

  /// Traces what the round has left. False when it was stopped.
  bool trace_round(const std::vector<std::uint32_t>& blocks) {
    passes_seen_ = 0;
    for (const auto& [samples, group] : by_samples(blocks)) {
      const std::uint32_t wanted =
          position_.round == 0 ? std::min(kFirstSamples, (settings_.spp + 1) / 2) : 2 * samples;
      if (!trace_blocks(group, {samples, std::min(wanted, settings_.spp)})) return false;
    }
    return true;
  }

 private:
  BlocksBySamples by_samples(const std::vector<std::uint32_t>& blocks) const {
    BlocksBySamples groups;
    for (const std::uint32_t number : blocks) groups[position_.errors.samples(number)].push_back(number);
    return groups;
  }

  /// Takes samples [begin, end) of `blocks`.
  bool trace_blocks(const std::vector<std::uint32_t>& blocks, const SamplePass& range) {
    for (const PixelRect& tile : tiles_) {
      const PixelRect in_film{tile.x - area_.x, tile.y - area_.y, tile.width, tile.height};
      const std::vector<std::uint32_t> pixels = listed_pixels(position_.errors, blocks, in_film);
      if (pixels.empty()) continue;
      const std::uint32_t length = tracer_.samples_of_pass(pixels.size());
      for (std::uint32_t begin = range.begin; begin < range.end; begin += length) {
        if (!trace_pass(tile, pixels, {begin, std::min(begin + length, range.end)})) return false;
      }
    }
    return true;
  }

  /// The same, unless it was done before.
  bool trace_pass(const PixelRect& tile, const std::vector<std::uint32_t>& pixels, const SamplePass& pass) {
    if (passes_seen_++ < position_.passes_done) return true;
    if (!tracer_.run_pixels(tile, pixels, pass, callbacks_.stop)) return false;
    ++position_.passes_done;
    callbacks_.after_pass();
    return true;
  }

  TileTracer& tracer_;
  const RenderSettings& settings_;
  AdaptivePosition& position_;
  const AdaptiveCallbacks& callbacks_;
  PixelRect area_;
  std::vector<PixelRect> tiles_;
  std::uint32_t passes_seen_ = 0;
};

}  // namespace

void trace_to_target(const Device& device, TileTracer& tracer, const Film& film, const RenderSettings& settings,
                     AdaptivePosition& position, const AdaptiveCallbacks& callbacks) {
  AdaptiveTrace trace(tracer, film, settings, position, callbacks);
  for (std::vector<std::uint32_t> blocks = trace.blocks(); !blocks.empty(); blocks = trace.blocks()) {
    if (!trace.trace_round(blocks)) return;
    position.errors.update(develop(film.read_sums(device), film.area()));
    ++position.round;
    position.passes_done = 0;
    callbacks.progress(share_at(position, *settings.error_target));
  }
}

std::optional<ErrorEstimate> estimate_at(const AdaptivePosition& position) {
  if (position.round < 2) return std::nullopt;
  return position.errors.estimate();
}

double share_at(const AdaptivePosition& position, double target) {
  const std::optional<ErrorEstimate> estimate = estimate_at(position);
  if (!estimate) return 0.0;
  const double reached = estimate->bound();
  return reached > target ? target * target / (reached * reached) : 1.0;
}

}  // namespace vernier
