#include "preview/latency.h"

#include <algorithm>
#include <cstdio>

namespace vernier {
namespace {

/// A minute of moving; what comes after is not noted.
constexpr std::size_t kMostWaits = 2000;

}  // namespace

void Latency::input(Clock::time_point earliest) {
  if (!waiting_) input_ = earliest;
  waiting_ = true;
}

void Latency::picture(bool of_input) {
  const Clock::time_point now = Clock::now();
  const auto since = [&](Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(now - start).count();
  };
  if (first_ms_ < 0.0) first_ms_ = since(opened_);
  if (!waiting_ || !of_input) return;
  waiting_ = false;
  if (waits_ms_.size() < kMostWaits) waits_ms_.push_back(since(input_));
}

std::string Latency::text() const {
  char text[160];
  std::snprintf(text, sizeof text, "first picture after %.0f ms", first_ms_);
  if (waits_ms_.empty()) return text;
  std::vector<double> sorted = waits_ms_;
  std::ranges::sort(sorted);
  std::snprintf(text, sizeof text,
                "first picture after %.0f ms; input to picture %.0f ms (median of %zu), %.0f ms at most", first_ms_,
                sorted[sorted.size() / 2], sorted.size(), sorted.back());
  return text;
}

}  // namespace vernier
