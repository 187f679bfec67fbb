#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <string_view>

namespace vernier {

/// Random numbers for one sample of a case: a function of seed, case and sample number alone, so that a failing sample
/// can be made again by itself. SplitMix64 (Steele, Lea, Flood 2014, Fast Splittable Pseudorandom Number Generators).
class SampleRandom {
 public:
  /// For sample number `sample` of the case.
  SampleRandom(std::uint64_t seed, std::string_view case_name, std::uint64_t sample);

  /// 64 random bits.
  std::uint64_t bits();
  /// Uniform in [0, 1), a multiple of 2^-53.
  double unit();
  /// Uniform in [lo, hi).
  double in(double lo, double hi);
  /// 10 to a uniform power in [lo, hi).
  double power_of_ten(double lo, double hi);
  /// 0 to count - 1; count is at least 1.
  std::uint32_t below(std::uint32_t count);
  /// Uniform on the unit sphere.
  glm::dvec3 direction();
  /// `value` moved by `steps` representable floats upwards (downwards where negative).
  static float stepped(float value, int steps);

 private:
  std::uint64_t state_;
};

}  // namespace vernier
