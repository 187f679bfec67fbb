#include "render/error_estimate.h"

#include <cmath>

namespace vernier {

double ErrorEstimate::bound() const {
  // Of the normal distribution: 95 % lie below so many standard errors.
  constexpr double kQuantile95 = 1.6448536269514722;
  return std::sqrt(rel_mse + kQuantile95 * standard_error);
}

}  // namespace vernier
