#pragma once

#include <vector>

namespace vernier {

/// Median, least and most.
struct Spread {
  double median = 0.0;
  double least = 0.0;
  double most = 0.0;
};

/// The spread of `values`; at least one. Of an even number the median is the mean of the middle two.
Spread spread_of(std::vector<double> values);

}  // namespace vernier
