#include "render/adaptive_trace.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <vector>

#include "render/error_map.h"

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

/// Takes samples [begin, end) of `blocks`.
bool trace_blocks(TileTracer& tracer, const Film& film, const ErrorMap& errors,
                  const std::vector<std::uint32_t>& blocks, const SamplePass& range,
                  const std::function<bool()>& stop) {
  for (const PixelRect& tile : tracer.tiles(film.area())) {
    const PixelRect in_film{tile.x - film.area().x, tile.y - film.area().y, tile.width, tile.height};
    const std::vector<std::uint32_t> pixels = listed_pixels(errors, blocks, in_film);
    if (pixels.empty()) continue;
    const std::uint32_t length = tracer.samples_of_pass(pixels.size());
    for (std::uint32_t begin = range.begin; begin < range.end; begin += length) {
      const SamplePass pass{begin, std::min(begin + length, range.end)};
      if (!tracer.run_pixels(tile, pixels, pass, stop)) return false;
    }
  }
  return true;
}

BlocksBySamples by_samples(const ErrorMap& errors, const std::vector<std::uint32_t>& blocks) {
  BlocksBySamples groups;
  for (const std::uint32_t number : blocks) groups[errors.samples(number)].push_back(number);
  return groups;
}

std::vector<std::uint32_t> all_blocks(const ErrorMap& errors, int height) {
  const int rows = (height + kErrorBlock - 1) / kErrorBlock;
  std::vector<std::uint32_t> blocks(static_cast<std::size_t>(errors.block_columns()) * rows);
  std::iota(blocks.begin(), blocks.end(), 0u);
  return blocks;
}

}  // namespace

std::optional<ErrorEstimate> trace_to_target(const Device& device, TileTracer& tracer, const Film& film,
                                             const RenderSettings& settings, const std::function<bool()>& stop,
                                             const AdaptiveProgress& progress) {
  ErrorMap errors(film.area().width, film.area().height);
  const double target = settings.error_target.value();
  std::vector<std::uint32_t> blocks = all_blocks(errors, film.area().height);
  std::optional<ErrorEstimate> estimate;
  for (bool first = true; !blocks.empty(); first = false) {
    for (const auto& [samples, group] : by_samples(errors, blocks)) {
      const std::uint32_t wanted = first ? std::min(kFirstSamples, (settings.spp + 1) / 2) : 2 * samples;
      if (!trace_blocks(tracer, film, errors, group, {samples, std::min(wanted, settings.spp)}, stop)) return estimate;
    }
    errors.update(develop(film.read_sums(device), film.area()));
    if (first) continue;
    estimate = errors.estimate();
    // The square of the error falls like the reciprocal of the work, or faster.
    const double reached = estimate->bound();
    progress(reached > target ? target * target / (reached * reached) : 1.0);
    blocks = errors.choose_blocks(target, settings.spp);
  }
  return estimate;
}

}  // namespace vernier
