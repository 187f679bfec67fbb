#pragma once

#include <optional>
#include <vector>

#include "render/error_map.h"

namespace vernier {

/// Estimates of a picture's error while its samples come in. Pure.
class ErrorHistory {
 public:
  /// Of a picture of `width` x `height` pixels without samples.
  ErrorHistory(int width, int height) : map_(width, height) {}

  /// One estimate.
  struct Point {
    double seconds = 0.0;  ///< since tracing began
    float error = 0.0f;    ///< sqrt(relMSE) that the true one stays below with 95 % confidence
  };

  /// Whether a film of `samples` per pixel tells anything new: half as many again as at the last look, since reading a
  /// film takes as long as some dispatches.
  bool wants(std::uint32_t samples) const;
  /// Takes the film with `samples` in every pixel at `seconds`.
  void add(const DevelopedFilm& film, std::uint32_t samples, double seconds);
  /// In the order of time; none before two looks.
  const std::vector<Point>& points() const { return points_; }
  /// Pixels that were not finite at the last look: what the others' error is worth then, no number tells.
  std::uint64_t not_finite() const { return not_finite_; }

 private:
  ErrorMap map_;
  std::uint32_t samples_ = 0;
  std::uint64_t not_finite_ = 0;
  std::vector<Point> points_;
};

}  // namespace vernier
