#pragma once

#include <string>

#include "gpu/device.h"

namespace vernier {

/// What min and max return when one operand is NaN.
enum class NanChoice { number, first_operand, second_operand, nan, other };

/// The choice in words: "the number", "the first operand" and so on.
std::string to_string(NanChoice choice);

/// What a device's float32 arithmetic does where the Vulkan specification leaves a choice.
struct ProbeResult {
  bool fma_is_fused = false;               ///< GLSL fma() rounds once
  bool plain_sum_is_fused = false;         ///< a*b+c without `precise` rounds once
  bool precise_sum_is_fused = false;       ///< with `precise`; true would be a driver bug
  bool two_sum_survives = false;           ///< Knuth's two-sum finds its error term without `precise`
  bool precise_two_sum_survives = false;   ///< with `precise`; false would be a driver bug
  bool denormals_kept_by_sum = false;      ///< x + x of a denormal x is right
  bool denormals_kept_by_product = false;  ///< 3 x of a denormal x is right
  bool isnan_works = false;                ///< isnan() of a NaN that was loaded
  NanChoice min_of_nan = NanChoice::other;
  NanChoice max_of_nan = NanChoice::other;
  double max_division_error_ulps = 0.0;  ///< over a fixed set of normal operands; 0.5 is correctly rounded, 2.5 allowed
  bool float64 = false;                  ///< shaders may use double
};

/// Runs a small shader on `device` and reports what it found. Takes about the time of one shader compilation.
/// The same device and driver give the same answer. Throws Error(failed) or Error(device_lost) like any submission.
ProbeResult probe_device(const Device& device);

}  // namespace vernier
