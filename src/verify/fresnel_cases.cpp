#include "verify/fresnel_cases.h"

#include <algorithm>
#include <cmath>

#include "verify/fresnel_oracle.h"
#include "verify/function_kernel.h"
#include "verify/level_bound.h"
#include "verify/random.h"
#include "verify/tally.h"

namespace vernier {
namespace {

// numerics.md 5.3.
constexpr double kReflectedRobust = 2e-5, kReflectedExact = 1e-7;
constexpr double kEnergyRobust = 1e-6, kEnergyExact = 1e-7;

std::string named(const FunctionOperands& o) {
  return hex_floats({{"cosine", o[0]}, {"eta", o[1]}});
}

std::vector<FunctionOperands> sweep(const CaseSetup& setup, const char* name) {
  std::vector<FunctionOperands> operands(setup.sample_count);
  for (std::uint64_t i = 0; i < setup.sample_count; ++i) {
    SampleRandom random(setup.seed, name, i);
    const double cosine = i % 2 == 0 ? random.unit() : random.power_of_ten(-8.0, 0.0);
    operands[i][0] = std::min(static_cast<float>(cosine), 1.0f);
    operands[i][1] = static_cast<float>(random.power_of_ten(-3.0, 3.0));
  }
  return operands;
}

/// Books |R - exact R| of each call.
void book_reflected(Tally& tally, const std::vector<FunctionOperands>& operands,
                    const std::vector<FunctionAnswers>& answers) {
  for (std::size_t i = 0; i < operands.size(); ++i) {
    const FunctionOperands& o = operands[i];
    const ExactFresnel exact = exact_fresnel(o[0], o[1]);
    tally.book_error(std::abs(static_cast<double>(answers[i][0] - exact.reflected)), [&] { return named(o); });
  }
}

}  // namespace

CaseResult run_fresnel_sweep(const CaseSetup& setup) {
  Tally tally("absolute", level_bound(setup, kReflectedRobust, kReflectedExact));
  const auto operands = sweep(setup, "fresnel_sweep");
  book_reflected(tally, operands, call_shader_function(setup, VERIFY_FRESNEL, operands));
  return tally.result();
}

CaseResult run_fresnel_energy(const CaseSetup& setup) {
  Tally tally("absolute", level_bound(setup, kEnergyRobust, kEnergyExact));
  const auto operands = sweep(setup, "fresnel_energy");
  const auto answers = call_shader_function(setup, VERIFY_FRESNEL, operands);
  for (std::size_t i = 0; i < operands.size(); ++i) {
    const double sum = static_cast<double>(answers[i][0]) + static_cast<double>(answers[i][1]);
    tally.book_error(std::abs(sum - 1.0), [&] { return named(operands[i]); });
  }
  return tally.result();
}

CaseResult run_fresnel_near_one(const CaseSetup& setup) {
  std::vector<FunctionOperands> operands(setup.sample_count);
  for (std::uint64_t i = 0; i < setup.sample_count; ++i) {
    SampleRandom random(setup.seed, "fresnel_near_one", i);
    // A quarter at the last places around 1, a sixteenth at 1 itself.
    const int steps = static_cast<int>(random.below(9)) - 4;
    const double apart = random.power_of_ten(-7.0, -2.0) * (random.below(2) == 0 ? 1.0 : -1.0);
    operands[i][0] = static_cast<float>(random.below(2) == 0 ? random.unit() : random.power_of_ten(-8.0, 0.0));
    operands[i][1] = i % 16 == 0  ? 1.0f
                     : i % 4 == 1 ? SampleRandom::stepped(1.0f, steps)
                                  : static_cast<float>(1.0 + apart);
  }
  const auto answers = call_shader_function(setup, VERIFY_FRESNEL, operands);
  Tally tally("absolute", level_bound(setup, kReflectedRobust, kReflectedExact));
  for (std::size_t i = 0; i < operands.size(); ++i) {
    const FunctionOperands& o = operands[i];
    const long double exact = exact_fresnel(o[0], o[1]).reflected;
    const double error = std::abs(static_cast<double>(answers[i][0] - exact));
    // Equal indices reflect nothing at all: any trace of it counts as a whole.
    const bool trace = o[1] == 1.0f && o[0] > 0.0f && setup.level != Accuracy::fast && answers[i][0] != 0.0f;
    tally.book_error(trace ? 1.0 : error, [&] { return named(o); });
  }
  return tally.result();
}

CaseResult run_critical_angle(const CaseSetup& setup) {
  std::vector<FunctionOperands> operands(setup.sample_count);
  for (std::uint64_t i = 0; i < setup.sample_count; ++i) {
    SampleRandom random(setup.seed, "critical_angle", i);
    const auto eta = static_cast<float>(random.in(0.1, 0.9999));
    const double critical = std::sqrt((1.0 - eta) * (1.0 + static_cast<double>(eta)));
    const double side = random.below(2) == 0 ? 1.0 : -1.0;
    const double factor = 1.0 + side * std::exp2(-1.0 - random.below(30));
    operands[i][0] = std::min(static_cast<float>(critical * factor), 1.0f);
    operands[i][1] = eta;
  }
  const auto answers = call_shader_function(setup, VERIFY_FRESNEL, operands);
  Tally tally;
  // k and c^2 are rounded twice and once, their sum once more; all are at most 1: four half ulps of 1.
  const double undecided = setup.level == Accuracy::exact ? 0.0 : 4.0 * 0x1p-24;
  for (std::size_t i = 0; i < operands.size(); ++i) {
    const FunctionOperands& o = operands[i];
    const long double g_squared = exact_g_squared(o[0], o[1]);
    const bool total = answers[i][1] == 0.0f && answers[i][0] == 1.0f;
    const bool either = std::abs(static_cast<double>(g_squared)) <= undecided && std::isfinite(answers[i][0]);
    const bool held = either || total == !(g_squared > 0.0L) || setup.level == Accuracy::fast;
    tally.book(held, [&] { return named(o); });
  }
  return tally.result();
}

CaseResult run_grazing_glass(const CaseSetup& setup) {
  constexpr double kRobust = 16.0, kExact = 1.0;  // docstring
  std::vector<FunctionOperands> operands(setup.sample_count);
  for (std::uint64_t i = 0; i < setup.sample_count; ++i) {
    SampleRandom random(setup.seed, "grazing_glass", i);
    operands[i][0] = static_cast<float>(std::exp2(-1.0 - random.below(26)) * random.in(1.0, 2.0));
    operands[i][1] = static_cast<float>(random.in(1.01, 3.0));
  }
  const auto answers = call_shader_function(setup, VERIFY_FRESNEL, operands);
  Tally tally("ulp", level_bound(setup, kRobust, kExact));
  for (std::size_t i = 0; i < operands.size(); ++i) {
    const FunctionOperands& o = operands[i];
    const auto exact = static_cast<double>(exact_fresnel(o[0], o[1]).transmitted);
    tally.book_error(ulps_from(answers[i][1], exact), [&] { return named(o); });
  }
  return tally.result();
}

}  // namespace vernier
