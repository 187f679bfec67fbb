#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <map>
#include <string>
#include <vector>

#include "render/error_map.h"
#include "render/render_settings.h"
#include "render/render_statistics.h"

namespace vernier {

/// Where a trace stands: every pixel has the samples before `pass_begin`, and the pass that begins there is done in the
/// first `tiles_done` tiles of schedule_tiles. With an error target these are an AdaptivePosition's round and
/// passes_done.
struct TracePosition {
  glm::ivec2 tile = glm::ivec2(0);  ///< pixels; the passes and the order of the tiles follow from it
  std::uint32_t pass_begin = 0;
  std::uint32_t tiles_done = 0;
};

/// A film off the device, and what it takes to go on with it.
struct SavedFilm {
  std::map<std::string, std::string> recipe;  ///< what decides its bits
  PixelRect area;
  TracePosition position;
  RayCounts rays;  ///< these and what follows: up to here
  std::uint64_t stack_overflows = 0;
  double device_ms = 0.0;
  double wall_ms = 0.0;
  std::vector<std::uint32_t> sums;  ///< [area.height][area.width][FILM_WORDS]; empty: no sample yet
  std::vector<PixelError> errors;   ///< [area.height][area.width], with an error target; empty: no round yet
};

/// Writes `film` as the file `path`, whole or not at all (write_whole), and on the disk before it takes that name, so
/// that a power failure leaves a whole one, this or the one before. Throws Error(failed) with `path` and the reason.
void write_film_file(const std::string& path, const SavedFilm& film);

/// Whether `path` begins like a file of write_film_file, of this version.
bool is_film_file(const std::string& path);

/// Reads a file that write_film_file wrote, of this byte order. Memory is taken only as far as the file really holds
/// sums. Throws Error(refused) with `path` for a file that is not there, of another kind or version, cut short, too
/// long or damaged in any byte.
SavedFilm read_film_file(const std::string& path);

}  // namespace vernier
