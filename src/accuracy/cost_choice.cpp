#include "accuracy/cost_choice.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace vernier {

std::vector<std::size_t> pareto_front(std::span<const CostAndError> points) {
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::erase_if(order,
                [&](std::size_t i) { return !std::isfinite(points[i].time_ms) || !std::isfinite(points[i].error); });
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
    if (points[a].time_ms != points[b].time_ms) return points[a].time_ms < points[b].time_ms;
    return points[a].error < points[b].error;
  });
  std::vector<std::size_t> front;
  double least = std::numeric_limits<double>::infinity();
  for (const std::size_t i : order) {
    if (points[i].error >= least) continue;
    least = points[i].error;
    front.push_back(i);
  }
  return front;
}

std::optional<std::size_t> cheapest_within(std::span<const CostAndError> points, double error) {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!(points[i].error <= error)) continue;
    if (!best || points[i].time_ms < points[*best].time_ms) best = i;
  }
  return best;
}

std::optional<double> log_slope(std::span<const CostAndError> points) {
  double x_sum = 0.0, y_sum = 0.0, xx_sum = 0.0, xy_sum = 0.0;
  for (const CostAndError& point : points) {
    if (!(point.time_ms > 0.0) || !(point.error > 0.0)) return std::nullopt;
    const double x = std::log(point.time_ms);
    const double y = std::log(point.error);
    x_sum += x;
    y_sum += y;
    xx_sum += x * x;
    xy_sum += x * y;
  }
  const double count = static_cast<double>(points.size());
  const double width = count * xx_sum - x_sum * x_sum;
  // Rounding leaves this much of the squares where all times are the same.
  constexpr double kRounding = 1e-12;
  if (points.size() < 2 || width <= kRounding * count * xx_sum) return std::nullopt;
  return (count * xy_sum - x_sum * y_sum) / width;
}

std::vector<double> round_errors(double least, double most) {
  std::vector<double> errors;
  if (!(least > 0.0) || !std::isfinite(most)) return errors;
  for (int power = static_cast<int>(std::ceil(std::log10(most))); power >= std::floor(std::log10(least)); --power) {
    for (const double digit : {5.0, 2.0, 1.0}) {
      const double error = digit * std::pow(10.0, power);
      if (error >= least && error <= most) errors.push_back(error);
    }
  }
  return errors;
}

}  // namespace vernier
