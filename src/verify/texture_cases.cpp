#include "verify/texture_cases.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "shared/material_flags.h"
#include "verify/function_suite.h"
#include "verify/texture_oracle.h"

namespace vernier {
namespace {

float anywhere(SampleRandom& random) {
  return static_cast<float>((random.below(2) == 0 ? 1.0 : -1.0) * random.power_of_ten(-12.0, 8.0));
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
  return judged_calls(
      setup, "texture_wrap", VERIFY_TEXTURE,
      [&](SampleRandom& random, std::uint64_t i) {
        const float u = i % 2 == 0 ? kHard[i / 2 % std::size(kHard)] : anywhere(random);
        const float size = kSizes[random.below(std::size(kSizes))];
        return FunctionOperands{u, 0.0f, size, 1.0f, static_cast<float>(random.below(3)), TEXTURE_FILTER_NEAREST};
      },
      [](const FunctionOperands& o, const FunctionAnswers& a) {
        if (!std::isfinite(o[0])) return a[0] == 0.0f;
        // Within the period alone: a place next to its end is never read at its start, but for a denormal, which a
        // device may take for 0.
        const auto wrap = static_cast<std::uint32_t>(o[4]);
        const long double place = wrapped_place(o[0], wrap), room = 0x1p-22L;
        const bool may_be_zero = std::abs(o[0]) < std::numeric_limits<float>::min();
        const long double other = may_be_zero ? 0.0L : place;
        return std::ranges::any_of(std::initializer_list{place - room, place, place + room, other}, [&](long double x) {
          return a[0] == static_cast<float>(texel_of(x, static_cast<long>(o[2])));
        });
      });
}

CaseResult run_bilinear(const CaseSetup& setup) {
  constexpr float kSizes[] = {1, 2, 3, 17, 64};
  return measured_calls(
      setup, "bilinear", VERIFY_TEXTURE, {"half ulps of the texture", 6.0, 6.0},
      [&](SampleRandom& random, std::uint64_t i) {
        const auto size = [&] { return kSizes[random.below(std::size(kSizes))]; };
        const auto place = [&] { return i % 4 == 0 ? anywhere(random) : static_cast<float>(random.in(-2.0, 2.0)); };
        const float u = place(), v = place(), width = size(), height = size();
        return FunctionOperands{u, v, width, height, static_cast<float>(random.below(3)), TEXTURE_FILTER_LINEAR};
      },
      [](const FunctionOperands& o, const FunctionAnswers& a) {
        const auto wrap = static_cast<std::uint32_t>(o[4]);
        const long double width = o[2], height = o[3];
        const LinearRead x = exact_linear(o[0], static_cast<long>(o[2]), wrap);
        const LinearRead y = exact_linear(o[1], static_cast<long>(o[3]), wrap);
        const long double size = width * x.slope + width * height * y.slope + width * height;
        return static_cast<double>(std::abs(a[0] - (x.value + width * y.value)) / (size * 0x1p-24L));
      });
}

CaseResult run_interpolated_uv(const CaseSetup& setup) {
  return measured_calls(
      setup, "interpolated_uv", VERIFY_UV, {"half ulps of the largest corner", 6.0, 6.0},
      [](SampleRandom& random, std::uint64_t) {
        FunctionOperands o{};
        const double size = random.power_of_ten(-4.0, 4.0);
        for (std::size_t k = 0; k < 6; ++k) o[k] = static_cast<float>(random.in(0.0, size));
        o[6] = static_cast<float>(random.power_of_ten(-6.0, 0.0));
        o[7] = static_cast<float>((1.0 - o[6]) * random.unit());
        return o;
      },
      [](const FunctionOperands& o, const FunctionAnswers& a) {
        const long double b1 = o[6], b2 = o[7];
        double error = 0.0;
        for (std::size_t k = 0; k < 2; ++k) {
          const long double exact = o[k] * (1.0L - b1 - b2) + o[k + 2] * b1 + o[k + 4] * b2;
          const double largest = 0x1p-24 * std::max({o[k], o[k + 2], o[k + 4]});
          const double one = static_cast<double>(std::abs(a[k] - exact)) / largest;
          if (!(one <= error)) error = one;
        }
        return error;
      });
}

}  // namespace vernier
