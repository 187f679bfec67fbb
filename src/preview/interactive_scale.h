#pragma once

#include <glm/glm.hpp>

namespace vernier {

/// Chooses how coarse a picture is while the camera moves, so that one takes about the time wanted. Pure.
class InteractiveScale {
 public:
  /// One picture is to take about `wanted_ms`.
  explicit InteractiveScale(double wanted_ms) : wanted_ms_(wanted_ms) {}

  /// Pixels of the next picture in place of `full`: a whole fraction of both sides, 1/1 to 1/16, never less than 1.
  glm::ivec2 size(glm::ivec2 full) const;
  /// A picture of `pixels` with one sample each took `ms`.
  void took(double pixels, double ms);

 private:
  double wanted_ms_;
  double ms_per_pixel_ = 1e-3;  // a slow CPU, until one has been timed
};

}  // namespace vernier
