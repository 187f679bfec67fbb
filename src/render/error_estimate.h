#pragma once

namespace vernier {

/// The error of an image as its samples tell it.
struct ErrorEstimate {
  double rel_mse = 0.0;         ///< mean over pixels and channels of (a - b)^2 / (b^2 + 0.01), b the converged image
  double standard_error = 0.0;  ///< of rel_mse

  /// sqrt(relMSE) that the true one stays below with 95 % confidence.
  double bound() const;
};

}  // namespace vernier
