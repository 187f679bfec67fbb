#include "accuracy/interval.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace vernier {
namespace {

double mean_of(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Standard deviation of one value, from at least two.
double deviation_of(std::span<const double> values, double mean) {
  double squares = 0.0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  return std::sqrt(squares / static_cast<double>(values.size() - 1));
}

}  // namespace

double student_t(std::size_t degrees) {
  constexpr std::array kQuantiles{12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262, 2.228,
                                  2.201,  2.179, 2.160, 2.145, 2.131, 2.120, 2.110, 2.101, 2.093, 2.086,
                                  2.080,  2.074, 2.069, 2.064, 2.060, 2.056, 2.052, 2.048, 2.045, 2.042};
  return degrees <= kQuantiles.size() ? kQuantiles[degrees - 1] : 1.96;
}

Interval interval_of(std::span<const double> values) {
  const double mean = mean_of(values);
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (values.size() < 2) return {mean, mean - kInfinity, mean + kInfinity};
  const double count = static_cast<double>(values.size());
  const double half = student_t(values.size() - 1) * deviation_of(values, mean) / std::sqrt(count);
  return {mean, mean - half, mean + half};
}

double bound_of_next(std::span<const double> values) {
  const double mean = mean_of(values);
  const double count = static_cast<double>(values.size());
  return mean + student_t(values.size() - 1) * deviation_of(values, mean) * std::sqrt(1.0 + 1.0 / count);
}

}  // namespace vernier
