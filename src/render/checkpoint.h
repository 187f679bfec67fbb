#pragma once

#include <chrono>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "gpu/device.h"
#include "render/film.h"
#include "render/film_file.h"
#include "render/trace_statistics.h"

namespace vernier {

/// Seconds between two checkpoints at least.
inline constexpr double kCheckpointInterval_s = 30.0;

/// Saves a film now and then. Saving takes at most a hundredth of the time: the next is due after the interval or a
/// hundred times what the last one took, whichever is longer.
class Checkpoint {
 public:
  /// Saves as the film file `file`, with `recipe`. `warn` gets a line for each time that fails; the render goes on, and
  /// what was saved before stays.
  Checkpoint(std::string file, std::map<std::string, std::string> recipe, double interval_s,
             std::function<void(const std::string&)> warn);

  /// Saves that nothing is done of `area` yet, at `start`: whoever is killed before the first checkpoint can resume.
  /// A file that is there already stays until something is done.
  void save_start(const PixelRect& area, const TracePosition& start);
  /// Whether it is time to save a film of so many bytes.
  bool is_due(std::uint64_t film_bytes) const;
  /// Saves `film` at `position`; `statistics` say what it took so far, `errors` what is known with an error target.
  /// Waits for the device.
  void save(const Device& device, const Film& film, const TracePosition& position, const TraceStatistics& statistics,
            std::vector<PixelError> errors);
  /// Whether a save has written the file; one that fails later leaves it.
  bool is_saved() const { return saved_; }

 private:
  using Clock = std::chrono::steady_clock;
  void write(const SavedFilm& film);

  std::string file_;
  std::map<std::string, std::string> recipe_;
  double interval_s_;
  std::function<void(const std::string&)> warn_;
  Clock::time_point last_ = Clock::now();
  double last_cost_s_ = 0.0;
  bool saved_ = false;
};

}  // namespace vernier
