#pragma once

#include <span>

namespace vernier {

/// A mean and where the true one lies with 95 % confidence.
struct Interval {
  double mean = 0.0;
  double low = 0.0;
  double high = 0.0;
};

/// Student's t that 97.5 % of the distribution with `degrees` degrees of freedom (at least 1) lie below; a normal
/// distribution's from 31 on.
double student_t(std::size_t degrees);

/// Mean and 95 % interval of independent `values` by Student's t: at least one; of one alone the interval is
/// everything. Values that are not finite make all three NaN.
Interval interval_of(std::span<const double> values);

/// What the next independent value stays below with 97.5 % confidence, if `values` (at least two) are normal:
/// mean + t s sqrt(1 + 1/n).
double bound_of_next(std::span<const double> values);

}  // namespace vernier
