#pragma once

#include <cstdint>
#include <vector>

#include "render/render_settings.h"

namespace vernier {

/// `area` cut into tiles of at most `tile` pixels, row by row from the upper left. No tile crosses a multiple of
/// `band_height` rows counted from the top of `area`. Empty for an empty area; tile and band_height are positive.
std::vector<PixelRect> schedule_tiles(const PixelRect& area, glm::ivec2 tile, int band_height);

/// Samples [begin, end) of one pass over all tiles.
struct SamplePass {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
};

/// Passes that together take samples [begin, end) of every pixel: 1, 1, 2, 4, ... at most 16 at once, so that a whole
/// image is there early and after each pass.
std::vector<SamplePass> schedule_passes(std::uint32_t begin, std::uint32_t end);

/// The ray budget of the next dispatch of a tile, from that of the last one and the time it took: so that a dispatch
/// takes `wanted_ms`. It at most doubles from one to the next, and stays in [1, 2^20].
std::uint32_t next_ray_budget(std::uint32_t last_budget, double last_ms, double wanted_ms);

}  // namespace vernier
