#include "verify/texture_cases.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "shared/material_flags.h"
#include "verify/function_kernel.h"
#include "verify/level_bound.h"
#include "verify/random.h"
#include "verify/tally.h"

namespace vernier {
namespace {

/// Texel of a coordinate in exact arithmetic: x mod 1, mirrored or clamped, times size.
long exact_texel(long double x, long size, std::uint32_t wrap) {
  long double inside = wrap == TEXTURE_WRAP_CLAMP ? std::clamp(x, 0.0L, 1.0L) : x - std::floor(x);
  if (wrap == TEXTURE_WRAP_MIRROR) inside = 1.0L - std::abs(1.0L - (x - 2.0L * std::floor(x / 2.0L)));
  return std::clamp(static_cast<long>(std::floor(inside * static_cast<long double>(size))), 0L, size - 1);
}

bool is_right(float got, float u, long size, std::uint32_t wrap) {
  if (!std::isfinite(u)) return got == 0.0f;
  const auto room = 0x1p-22L;  // docstring
  const long texel = static_cast<long>(got);
  for (const long double x : {u - room, static_cast<long double>(u), u + room}) {
    if (texel == exact_texel(x, size, wrap) && static_cast<float>(texel) == got) return true;
  }
  return false;
}

}  // namespace

CaseResult run_texture_wrap(const CaseSetup& setup) {
  constexpr float kHard[] = {-1e-10f,
                             1.0f - 0x1p-24f,
                             1.0f,
                             0.0f,
                             -0.0f,
                             1e7f,
                             1e30f,
                             -1e30f,
                             -1e-38f,
                             0.5f,
                             std::numeric_limits<float>::quiet_NaN(),
                             std::numeric_limits<float>::infinity()};
  constexpr float kSizes[] = {1, 2, 3, 255, 1024, 4096};
  std::vector<FunctionOperands> operands(setup.sample_count);
  for (std::uint64_t i = 0; i < setup.sample_count; ++i) {
    SampleRandom random(setup.seed, "texture_wrap", i);
    const double sign = random.below(2) == 0 ? 1.0 : -1.0;
    const float u =
        i % 2 == 0 ? kHard[i / 2 % std::size(kHard)] : static_cast<float>(sign * random.power_of_ten(-12.0, 8.0));
    operands[i] = {u,
                   0.0f,
                   kSizes[random.below(std::size(kSizes))],
                   1.0f,
                   static_cast<float>(random.below(3)),
                   TEXTURE_FILTER_NEAREST};
  }
  const auto answers = call_shader_function(setup, VERIFY_TEXTURE, operands);
  Tally tally;
  for (std::size_t i = 0; i < operands.size(); ++i) {
    const FunctionOperands& o = operands[i];
    const bool held = is_right(answers[i][0], o[0], static_cast<long>(o[2]), static_cast<std::uint32_t>(o[4]));
    tally.book(held, [&] { return hex_floats({{"u", o[0]}, {"size", o[2]}, {"wrap", o[4]}, {"got", answers[i][0]}}); });
  }
  return tally.result();
}

CaseResult run_interpolated_uv(const CaseSetup& setup) {
  constexpr double kBound = 6.0;  // docstring
  std::vector<FunctionOperands> operands(setup.sample_count);
  for (std::uint64_t i = 0; i < setup.sample_count; ++i) {
    SampleRandom random(setup.seed, "interpolated_uv", i);
    const double size = random.power_of_ten(-4.0, 4.0);
    for (std::size_t k = 0; k < 6; ++k) operands[i][k] = static_cast<float>(random.in(0.0, size));
    operands[i][6] = static_cast<float>(random.power_of_ten(-6.0, 0.0));
    operands[i][7] = static_cast<float>((1.0 - operands[i][6]) * random.unit());
  }
  const auto answers = call_shader_function(setup, VERIFY_UV, operands);
  Tally tally("half ulps of the largest corner", level_bound(setup, kBound, kBound));
  for (std::size_t i = 0; i < operands.size(); ++i) {
    const FunctionOperands& o = operands[i];
    const long double b1 = o[6], b2 = o[7];
    double error = 0.0;
    for (std::size_t k = 0; k < 2; ++k) {
      const long double exact = o[k] * (1.0L - b1 - b2) + o[k + 2] * b1 + o[k + 4] * b2;
      const double one =
          static_cast<double>(std::abs(answers[i][k] - exact)) / (0x1p-24 * std::max({o[k], o[k + 2], o[k + 4]}));
      if (!(one <= error)) error = one;
    }
    tally.book_error(error, [&] {
      return hex_floats({{"u0", o[0]}, {"u1", o[2]}, {"u2", o[4]}, {"b1", o[6]}, {"b2", o[7]}});
    });
  }
  return tally.result();
}

}  // namespace vernier
