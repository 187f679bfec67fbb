#include "cli/progress_bar.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>

#include "math/elapsed.h"

namespace vernier {
namespace {

using std::chrono::steady_clock;

constexpr int kBarWidth = 30;  // with the figures behind it, a line of 80 columns
constexpr std::chrono::milliseconds kTerminalPause{100};
constexpr std::chrono::seconds kPlainPause{2};

std::string bar(double share, int width) {
  const int done = static_cast<int>(share * width);
  return "[" + std::string(static_cast<std::size_t>(done), '#') +
         std::string(static_cast<std::size_t>(width - done), '-') + "] ";
}

bool known(double value) {
  return std::isfinite(value) && value > 0.0;
}

}  // namespace

ProgressState WorkClock::at(double share, std::string_view work) const {
  const double seconds = seconds_since(start_);
  return {share, 0.0, share > 0.0 ? seconds * (1.0 - share) / share : 0.0, work};
}

std::string clock_text(double seconds) {
  const auto whole = static_cast<std::int64_t>(std::ceil(seconds));
  char text[48];
  if (whole >= 3600) {
    std::snprintf(text, sizeof text, "%lld:%02d:%02d", static_cast<long long>(whole / 3600),
                  static_cast<int>(whole / 60 % 60), static_cast<int>(whole % 60));
  } else {
    std::snprintf(text, sizeof text, "%d:%02d", static_cast<int>(whole / 60), static_cast<int>(whole % 60));
  }
  return text;
}

std::string rate_text(double rays_per_s) {
  constexpr double kFirstMrays = 1e5;
  char text[64];
  if (rays_per_s < kFirstMrays) {
    std::snprintf(text, sizeof text, "%.2f krays/s", rays_per_s * 1e-3);
  } else {
    std::snprintf(text, sizeof text, "%.2f Mrays/s", rays_per_s * 1e-6);
  }
  return text;
}

std::string progress_line(const ProgressState& state, int bar_width) {
  const double share = std::isfinite(state.share) ? std::clamp(state.share, 0.0, 1.0) : 0.0;
  std::string line = state.work.empty() ? "" : std::string(state.work) + " ";
  line += bar_width > 0 ? bar(share, bar_width) : "";
  char text[64];
  std::snprintf(text, sizeof text, "%3d %%", static_cast<int>(share * 100.0));
  line += text;
  if (known(state.rays_per_s)) {
    line += "  " + rate_text(state.rays_per_s);
  }
  constexpr double kLongest_s = 1e9;    // beyond 30 years an estimate says nothing
  constexpr double kLeastShare = 0.01;  // what has hardly begun tells nothing of its end
  if (known(state.eta_s) && state.eta_s < kLongest_s && share >= kLeastShare) {
    line += "  ETA " + clock_text(state.eta_s);
  }
  return line;
}

ProgressBar::ProgressBar(bool quiet)
    : quiet_(quiet), terminal_(isatty(STDERR_FILENO) == 1), next_(steady_clock::now() + kTerminalPause) {
  if (!terminal_) {
    next_ = steady_clock::now() + kPlainPause;
  }
}

ProgressBar::~ProgressBar() {
  clear();
}

void ProgressBar::clear() {
  if (!line_open_) return;
  std::fputs("\r\x1b[K", stderr);
  std::fflush(stderr);
  line_open_ = false;
}

void ProgressBar::update(const ProgressState& state) {
  const steady_clock::time_point now = steady_clock::now();
  if (quiet_ || now < next_) {
    return;
  }
  if (terminal_) {
    // Erasing to the end of the line hides what a longer line left behind.
    std::fprintf(stderr, "\r%s\x1b[K", progress_line(state, kBarWidth).c_str());
    std::fflush(stderr);
    line_open_ = true;
    next_ = now + kTerminalPause;
  } else {
    std::fprintf(stderr, "%s\n", progress_line(state, 0).c_str());
    next_ = now + kPlainPause;
  }
}

}  // namespace vernier
