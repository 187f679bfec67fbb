#pragma once

#include <chrono>
#include <string>
#include <string_view>

namespace vernier {

/// How far a piece of work is. Rates and times below 0 or not finite are unknown and left out.
struct ProgressState {
  double share = 0.0;       ///< in [0, 1]
  double rays_per_s = 0.0;  ///< 0: nothing is traced
  double eta_s = 0.0;
  std::string_view work = "";  ///< what is done, before the bar; empty for the render itself
};

/// Tells the time left from the share of the work that is done. Starts when it is made.
class WorkClock {
 public:
  /// The state of `work` at `share` in [0, 1], with the rest estimated from the time so far; no rate.
  ProgressState at(double share, std::string_view work = "") const;

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// One line without a line break: `[#####-----]  50 %  12.3 Mrays/s  ETA 1:05`; `bar_width` 0 leaves the bar out.
std::string progress_line(const ProgressState& state, int bar_width);

/// `12.34 Mrays/s`; `2.76 krays/s` below 100 000.
std::string rate_text(double rays_per_s);

/// `1:05`, `1:01:05`; whole seconds, rounded up.
std::string clock_text(double seconds);

/// Shows progress on stderr: a bar rewritten in place on a terminal, else a plain line every few seconds.
/// Owns the unfinished line on the terminal and clears it at the end. Not for several threads at once.
class ProgressBar {
 public:
  /// `quiet` shows nothing at all.
  explicit ProgressBar(bool quiet);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// Shows `state` if enough time has passed since the last one.
  void update(const ProgressState& state);

  /// Clears the unfinished line, for another text.
  void clear();

 private:
  bool quiet_;
  bool terminal_;
  bool line_open_ = false;
  std::chrono::steady_clock::time_point next_;
};

}  // namespace vernier
