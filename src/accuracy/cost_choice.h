#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace vernier {

/// What settings cost and give.
struct CostAndError {
  double time_ms = 0.0;
  double error = 0.0;
};

/// Indices of the `points` that no other beats: none is both at most as slow and at most as wrong, and better in one of
/// the two. By rising time. Of equal points the first; points that are not finite are never among them.
std::vector<std::size_t> pareto_front(std::span<const CostAndError> points);

/// The fastest of the `points` whose error is at most `error`; none where there is none.
std::optional<std::size_t> cheapest_within(std::span<const CostAndError> points, double error);

/// Slope of log(error) over log(time) by least squares; -1/2 is independent samples. None for fewer than two different
/// times or values that are not positive.
std::optional<double> log_slope(std::span<const CostAndError> points);

/// The errors a reader asks for, 1, 2 or 5 times a power of ten, within [`least`, `most`], falling. Empty for a range
/// that is not positive.
std::vector<double> round_errors(double least, double most);

}  // namespace vernier
