#include "render/tile_schedule.h"

#include <algorithm>

namespace vernier {
namespace {

constexpr std::uint32_t kMostSamplesPerPass = 16;
constexpr std::uint32_t kLargestRayBudget = 1u << 20;

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

std::vector<SamplePass> schedule_passes(std::uint32_t begin, std::uint32_t end) {
  std::vector<SamplePass> passes;
  std::uint32_t length = 1;
  for (std::uint32_t next = begin; next < end;) {
    const std::uint32_t pass_end = next + std::min(length, end - next);
    passes.push_back({next, pass_end});
    length = std::min(passes.size() == 1 ? 1u : 2 * length, kMostSamplesPerPass);
    next = pass_end;
  }
  return passes;
}

std::uint32_t next_ray_budget(std::uint32_t last_budget, double last_ms, double wanted_ms) {
  const double scale = last_ms > 0.0 ? std::min(wanted_ms / last_ms, 2.0) : 2.0;
  const double budget = std::clamp(last_budget * scale, 1.0, static_cast<double>(kLargestRayBudget));
  return static_cast<std::uint32_t>(budget);
}

}  // namespace vernier
