#include "render/tile_schedule.h"

#include <algorithm>

namespace vernier {
namespace {

// llvmpipe leaves loops after 65535 rounds in all: a search takes some twenty, seldom more than sixty.
constexpr std::uint32_t kLargestSearchBudget = 1u << 10;

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
