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

  /// Samples per pixel.
  std::uint32_t length() const { return end - begin; }
};

/// Samples of the longest pass.
constexpr std::uint32_t kMostSamplesPerPass = 16;
/// The samples of a pass over a tile wait in a buffer of at most that size.
constexpr std::uint64_t kMostPassBytes = 64u << 20;

/// Jobs of a tile per sample: incomplete blocks count as whole ones (shaders/job.glsl).
std::uint64_t jobs_per_sample(glm::ivec2 tile);

/// `tile` with its longer side halved until one sample of each pixel, of so many bytes, fits into kMostPassBytes and a
/// list of all its pixels into the workgroups side by side that every device takes.
glm::ivec2 fitting_tile(glm::ivec2 tile, std::uint64_t sample_bytes);

/// Samples of a pass over so many listed pixels (at least 1) where `room` samples fit into the buffer: at least 1, and
/// no more than the accumulate kernel's loop may take.
std::uint32_t listed_samples(std::uint64_t room, std::size_t pixels);

/// Passes that together take samples [begin, end) of every pixel: `first`, each 4 times the one before, 16 at once but
/// never more than `most` (both at least 1), so that a whole image is there early and after each pass.
std::vector<SamplePass> schedule_passes(std::uint32_t begin, std::uint32_t end, std::uint32_t first,
                                        std::uint32_t most);

/// Samples of the first pass over `area` that nobody watches: 1 to 4, a million altogether where that many fit. Every
/// pass ends with lanes that wait for the last paths.
std::uint32_t choose_first_pass(const PixelRect& area);

/// How many of the `left` jobs the next dispatch may take, at least 1 where any is left, so that it makes about
/// `searches` (above 0), by the `past_searches` that `past_jobs` took. Rather a little more than that than a little
/// left over.
std::uint64_t choose_jobs(double searches, std::uint64_t past_jobs, std::uint64_t past_searches, std::uint64_t left);

/// How many searches each of `invocations` may make in the next dispatch before it takes no further job, so that the
/// dispatch takes about `wanted_ms` at `ms_per_search` (both above 0): at least 1, at most 1024.
std::uint32_t choose_search_budget(double wanted_ms, double ms_per_search, std::uint32_t invocations);

/// After how many searches an invocation with that budget puts its path aside: enough beyond it that most paths come to
/// their end, without a dispatch of their own for the last of them.
std::uint32_t search_limit(std::uint32_t budget);

}  // namespace vernier
