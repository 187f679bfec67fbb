#include "render/tile_schedule.h"

#include <algorithm>

#include "render/tile_dispatch.h"
#include "shared/film_layout.h"

namespace vernier {
namespace {

// llvmpipe leaves loops after 65535 rounds in all: a search takes some twenty, seldom more than sixty.
constexpr std::uint32_t kLargestSearchBudget = 1u << 10;
// Half of that limit, for the loop over the samples of a pixel (shaders/accumulate_samples.glsl), which cannot tell
// whether it was cut off.
constexpr std::uint64_t kMostListedSamples = 1u << 15;
// Every device takes 65535 workgroups side by side (maxComputeWorkGroupCount); these are of 64.
constexpr std::uint64_t kMostListedPixels = 65535u * 64u;

}  // namespace

std::vector<PixelRect> schedule_tiles(const PixelRect& area, glm::ivec2 tile, int band_height) {
  std::vector<PixelRect> tiles;
  for (int band = 0; band < area.height; band += band_height) {
    const int band_end = std::min(band + band_height, area.height);
    for (int y = band; y < band_end; y += tile.y) {
      for (int x = 0; x < area.width; x += tile.x) {
        tiles.push_back({area.x + x, area.y + y, std::min(tile.x, area.width - x), std::min(tile.y, band_end - y)});
      }
    }
  }
  return tiles;
}

std::uint64_t jobs_per_sample(glm::ivec2 tile) {
  return std::uint64_t{blocks_of(tile.x)} * blocks_of(tile.y) * JOB_BLOCK_SIDE * JOB_BLOCK_SIDE;
}

glm::ivec2 fitting_tile(glm::ivec2 tile, std::uint64_t sample_bytes) {
  const std::uint64_t most_jobs = std::min(kMostPassBytes / sample_bytes, kMostListedPixels);
  while (jobs_per_sample(tile) > most_jobs) (tile.x > tile.y ? tile.x : tile.y) /= 2;
  return tile;
}

std::uint32_t listed_samples(std::uint64_t room, std::size_t pixels) {
  return static_cast<std::uint32_t>(std::clamp<std::uint64_t>(room / pixels, 1, kMostListedSamples));
}

std::vector<SamplePass> schedule_passes(std::uint32_t begin, std::uint32_t end, std::uint32_t first,
                                        std::uint32_t most) {
  std::vector<SamplePass> passes;
  std::uint32_t length = std::min({first, kMostSamplesPerPass, most});
  for (std::uint32_t next = begin; next < end;) {
    const std::uint32_t pass_end = next + std::min(length, end - next);
    passes.push_back({next, pass_end});
    length = std::min({4 * length, kMostSamplesPerPass, most});
    next = pass_end;
  }
  return passes;
}

std::uint32_t choose_first_pass(const PixelRect& area) {
  const std::int64_t pixels = std::max<std::int64_t>(static_cast<std::int64_t>(area.width) * area.height, 1);
  return static_cast<std::uint32_t>(std::clamp<std::int64_t>((std::int64_t{1} << 20) / pixels, 1, 4));
}

std::uint64_t choose_jobs(double searches, std::uint64_t past_jobs, std::uint64_t past_searches, std::uint64_t left) {
  constexpr double kLittleMore = 1.25;
  const double per_job =
      static_cast<double>(past_searches) / static_cast<double>(std::max<std::uint64_t>(past_jobs, 1));
  const double jobs = searches / std::max(per_job, 1.0);
  if (kLittleMore * jobs >= static_cast<double>(left)) return left;
  return std::max<std::uint64_t>(static_cast<std::uint64_t>(jobs), 1);
}

std::uint32_t choose_search_budget(double wanted_ms, double ms_per_search, std::uint32_t invocations) {
  const double budget = wanted_ms / (ms_per_search * std::max(invocations, 1u));
  return static_cast<std::uint32_t>(std::clamp(budget, 1.0, static_cast<double>(kLargestSearchBudget)));
}

std::uint32_t search_limit(std::uint32_t budget) {
  return budget + budget / 8 + 16;
}

}  // namespace vernier
