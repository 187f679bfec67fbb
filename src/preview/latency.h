#pragma once

#include <chrono>
#include <string>
#include <vector>

namespace vernier {

/// How long the user waited for pictures, at most: an event may have come right after the last look for events.
class Latency {
 public:
  /// The window opened.
  Latency() : opened_(Clock::now()) {}

  /// The camera was moved at `earliest` or later: the next picture answers to it.
  void input(std::chrono::steady_clock::time_point earliest);
  /// A picture was shown; `of_input`: it shows what the input asked for.
  void picture(bool of_input);

  /// `first picture after 412 ms; input to picture 96 ms (median of 14), 130 ms at most`.
  std::string text() const;

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point opened_;
  Clock::time_point input_;
  bool waiting_ = false;
  double first_ms_ = -1.0;
  std::vector<double> waits_ms_;
};

}  // namespace vernier
