#pragma once

#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <random>

namespace vernier {

/// Random numbers that are the same with every standard library.
class RandomValues {
 public:
  explicit RandomValues(std::uint32_t seed) : engine_(seed) {}

  std::uint32_t word() { return static_cast<std::uint32_t>(engine_()); }
  /// In [lo, hi), in double.
  double uniform(double lo, double hi) { return lo + (hi - lo) * (engine_() * 0x1p-32); }
  float in(double lo, double hi) { return static_cast<float>(uniform(lo, hi)); }
  /// 10 to a power in [lo, hi).
  float power_of_ten(double lo, double hi) { return static_cast<float>(std::pow(10.0, uniform(lo, hi))); }
  /// Each component in [-1, 1).
  glm::vec3 in_cube() {
    const float x = in(-1, 1), y = in(-1, 1), z = in(-1, 1);
    return {x, y, z};
  }
  /// Unit, all directions alike.
  glm::vec3 direction() {
    while (true) {
      const glm::dvec3 v(in_cube());
      const double length = glm::length(v);
      if (length > 0.01 && length < 1.0) return glm::vec3(v / length);
    }
  }

 private:
  std::mt19937 engine_;
};

}  // namespace vernier
