#include "preview/latency.h"

#include <cstdio>

#include "math/elapsed.h"
#include "math/spread.h"

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
  if (first_ms_ < 0.0) first_ms_ = ms_since(opened_);
  if (!waiting_ || !of_input) return;
  waiting_ = false;
  if (waits_ms_.size() < kMostWaits) waits_ms_.push_back(ms_since(input_));
}

std::string Latency::text() const {
  char text[160];
  std::snprintf(text, sizeof text, "first picture after %.0f ms", first_ms_);
  if (waits_ms_.empty()) return text;
  const Spread waits = spread_of(waits_ms_);
  std::snprintf(text, sizeof text,
                "first picture after %.0f ms; input to picture %.0f ms (median of %zu), %.0f ms at most", first_ms_,
                waits.median, waits_ms_.size(), waits.most);
  return text;
}

}  // namespace vernier
