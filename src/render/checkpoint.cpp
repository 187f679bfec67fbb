#include "render/checkpoint.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "error.h"
#include "math/elapsed.h"

namespace vernier {
namespace {

/// A hundred times the cost between two saves: under 1 % of the render.
constexpr double kCostShare = 100.0;
/// Taken for the speed of saving until a film has been saved: a slow disk.
constexpr double kFirstBytesPerSecond = 100e6;

}  // namespace

Checkpoint::Checkpoint(std::string file, std::map<std::string, std::string> recipe, double interval_s,
                       std::function<void(const std::string&)> warn)
    : file_(std::move(file)), recipe_(std::move(recipe)), interval_s_(interval_s), warn_(std::move(warn)) {}

void Checkpoint::save_start(const PixelRect& area, const TracePosition& start) {
  last_ = Clock::now();
  std::error_code failure;
  if (std::filesystem::is_regular_file(file_, failure)) return;
  SavedFilm film;
  film.area = area;
  film.position = start;
  film.recipe = recipe_;
  write(film);
}

bool Checkpoint::is_due(std::uint64_t film_bytes) const {
  const double cost_s = last_cost_s_ > 0.0 ? last_cost_s_ : static_cast<double>(film_bytes) / kFirstBytesPerSecond;
  const double wait_s = interval_s_ > 0.0 ? std::max(interval_s_, kCostShare * cost_s) : 0.0;
  return seconds_since(last_) >= wait_s;
}

void Checkpoint::save(const Device& device, const Film& film, const TracePosition& position,
                      const TraceStatistics& statistics, std::vector<PixelError> errors) {
  const Clock::time_point begin = Clock::now();
  write({.recipe = recipe_,
         .area = film.area(),
         .position = position,
         .rays = statistics.rays,
         .stack_overflows = statistics.stack_overflows,
         .device_ms = statistics.device_ms,
         .wall_ms = statistics.wall_ms,
         .sums = film.read_sums(device),
         .errors = std::move(errors)});
  last_ = Clock::now();
  last_cost_s_ = seconds_since(begin);
}

void Checkpoint::write(const SavedFilm& film) {
  try {
    write_film_file(file_, film);
    saved_ = true;
  } catch (const Error& error) {
    warn_(std::string(error.what()) + "; the render goes on");
  }
}

}  // namespace vernier
