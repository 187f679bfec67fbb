#include "verify/fresnel_cases.h"

#include <algorithm>
#include <cmath>

#include "verify/fresnel_oracle.h"
#include "verify/function_suite.h"

namespace vernier {
namespace {

// numerics.md 5.3.
constexpr ErrorTarget kReflected{"absolute", 2e-5, 1e-7};
constexpr ErrorTarget kEnergy{"absolute", 1e-6, 1e-7};

float cosine_of_any_size(SampleRandom& random) {
  const double cosine = random.below(2) == 0 ? random.unit() : random.power_of_ten(-8.0, 0.0);
  return std::min(static_cast<float>(cosine), 1.0f);
}

FunctionOperands any_boundary(SampleRandom& random, std::uint64_t) {
  const float cosine = cosine_of_any_size(random);
  return {cosine, static_cast<float>(random.power_of_ten(-3.0, 3.0))};
}

/// At the critical angle of an index ratio below 1 times 1 +- 2^-k, k from 1 to `least_power`.
FunctionOperands near_critical(SampleRandom& random, std::uint32_t least_power) {
  const auto eta = static_cast<float>(random.in(0.1, 0.9999));
  const double critical = std::sqrt((1.0 - eta) * (1.0 + static_cast<double>(eta)));
  const double side = random.below(2) == 0 ? 1.0 : -1.0;
  const double factor = 1.0 + side * std::exp2(-1.0 - random.below(least_power));
  return {std::min(static_cast<float>(critical * factor), 1.0f), eta};
}

double error_of_reflected(const FunctionOperands& o, const FunctionAnswers& a) {
  return std::abs(static_cast<double>(a[0] - exact_fresnel(o[0], o[1]).reflected));
}

}  // namespace

CaseResult run_fresnel_sweep(const CaseSetup& setup) {
  return measured_calls(setup, "fresnel_sweep", VERIFY_FRESNEL, kReflected, any_boundary, error_of_reflected);
}

CaseResult run_fresnel_energy(const CaseSetup& setup) {
  return measured_calls(setup, "fresnel_energy", VERIFY_FRESNEL, kEnergy, any_boundary,
                        [](const FunctionOperands&, const FunctionAnswers& a) {
                          return std::abs(static_cast<double>(a[0]) + static_cast<double>(a[1]) - 1.0);
                        });
}

CaseResult run_fresnel_near_one(const CaseSetup& setup) {
  return measured_calls(
      setup, "fresnel_near_one", VERIFY_FRESNEL, kReflected,
      [](SampleRandom& random, std::uint64_t i) {
        // A quarter at the last places around 1, a sixteenth at 1 itself.
        const int steps = static_cast<int>(random.below(9)) - 4;
        const double apart = random.power_of_ten(-7.0, -2.0) * (random.below(2) == 0 ? 1.0 : -1.0);
        const float eta = i % 16 == 0  ? 1.0f
                          : i % 4 == 1 ? SampleRandom::stepped(1.0f, steps)
                                       : static_cast<float>(1.0 + apart);
        return FunctionOperands{cosine_of_any_size(random), eta};
      },
      [&](const FunctionOperands& o, const FunctionAnswers& a) {
        // Equal indices reflect nothing at all: any trace of it counts as a whole.
        const bool trace = o[1] == 1.0f && o[0] > 0.0f && setup.level != Accuracy::fast && a[0] != 0.0f;
        return trace ? 1.0 : error_of_reflected(o, a);
      });
}

CaseResult run_fresnel_critical(const CaseSetup& setup) {
  return measured_calls(
      setup, "fresnel_critical", VERIFY_FRESNEL, kReflected,
      [](SampleRandom& random, std::uint64_t) { return near_critical(random, 30); }, error_of_reflected);
}

CaseResult run_critical_angle(const CaseSetup& setup) {
  return judged_calls(
      setup, "critical_angle", VERIFY_FRESNEL,
      [](SampleRandom& random, std::uint64_t) { return near_critical(random, 30); },
      [&](const FunctionOperands& o, const FunctionAnswers& a) {
        const bool total = a[1] == 0.0f && a[0] == 1.0f;
        return std::isfinite(a[0]) && total == !(exact_g_squared(o[0], o[1]) > 0.0L);
      });
}

CaseResult run_grazing_glass(const CaseSetup& setup) {
  return measured_calls(
      setup, "grazing_glass", VERIFY_FRESNEL, {"ulp", 16.0, 1.0},
      [](SampleRandom& random, std::uint64_t) {
        const double cosine = std::exp2(-1.0 - random.below(26)) * random.in(1.0, 2.0);
        return FunctionOperands{static_cast<float>(cosine), static_cast<float>(random.in(1.01, 3.0))};
      },
      [](const FunctionOperands& o, const FunctionAnswers& a) {
        return ulps_from(a[1], static_cast<double>(exact_fresnel(o[0], o[1]).transmitted));
      });
}

}  // namespace vernier
