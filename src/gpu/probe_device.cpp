#include "gpu/probe_device.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "gpu/buffer.h"
#include "gpu/compute_pipeline.h"
#include "gpu/submission.h"
#include "shared/probe_slots.h"
#include "spirv/probe.h"

namespace vernier {
namespace {

constexpr float kTiny = 0x1p-30F;       // lost when added to 1
constexpr float kDenormal = 0x1p-130F;  // below 2^-126, and three times it is exact

std::vector<float> make_operands() {
  std::vector<float> out(PROBE_OPERAND_COUNT);
  // (1 + 2^-12)^2 = 1 + 2^-11 + 2^-24, of which rounding drops the last term: it is left over only by a fused sum.
  out[PROBE_FACTOR] = 1.0F + 0x1p-12F;
  out[PROBE_ADDEND] = -(1.0F + 0x1p-11F);
  out[PROBE_PLAIN_FACTOR] = out[PROBE_FACTOR];
  out[PROBE_PLAIN_ADDEND] = out[PROBE_ADDEND];
  out[PROBE_ONE] = out[PROBE_PLAIN_ONE] = 1.0F;
  out[PROBE_TINY] = out[PROBE_PLAIN_TINY] = kTiny;
  out[PROBE_DENORMAL] = kDenormal;
  out[PROBE_THREE] = 3.0F;
  out[PROBE_NAN] = std::numeric_limits<float>::quiet_NaN();
  // Only the raw 32-bit output of mt19937 is the same everywhere.
  std::mt19937 random(1);
  const auto operand = [&random] {
    const float mantissa = 1.0F + static_cast<float>(random() >> 9) * 0x1p-23F;
    const int exponent = static_cast<int>(random() % 61) - 30;  // far from overflow and denormals
    return std::ldexp(mantissa, exponent);
  };
  for (std::uint32_t i = 0; i < 2 * PROBE_DIVISION_COUNT; ++i) out.push_back(operand());
  return out;
}

/// Distance of `value` from the normal `exact` in units of the float spacing at `exact`.
double error_ulps(float value, double exact) {
  const double spacing = std::ldexp(1.0, std::ilogb(exact) - 23);
  return std::abs(static_cast<double>(value) - exact) / spacing;
}

double max_division_error(const std::vector<float>& operands, const std::vector<std::uint32_t>& answers) {
  double worst = 0.0;
  for (std::size_t i = 0; i < PROBE_DIVISION_COUNT; ++i) {
    const double dividend = operands[PROBE_OPERAND_COUNT + 2 * i];
    const double divisor = operands[PROBE_OPERAND_COUNT + 2 * i + 1];
    const auto quotient = std::bit_cast<float>(answers[PROBE_ANSWER_COUNT + i]);
    const double error = error_ulps(quotient, dividend / divisor);
    worst = std::isnan(worst) || error <= worst ? worst : error;  // a NaN quotient stays
  }
  return worst;
}

NanChoice nan_choice(float with_nan_first, float with_nan_second) {
  const bool first_is_nan = std::isnan(with_nan_first);
  const bool second_is_nan = std::isnan(with_nan_second);
  if (first_is_nan && second_is_nan) return NanChoice::nan;
  if (first_is_nan && with_nan_second == 1.0F) return NanChoice::first_operand;
  if (second_is_nan && with_nan_first == 1.0F) return NanChoice::second_operand;
  return with_nan_first == 1.0F && with_nan_second == 1.0F ? NanChoice::number : NanChoice::other;
}

std::vector<std::uint32_t> run_probe(const Device& device, const std::vector<float>& operands) {
  std::vector<std::uint32_t> answers(PROBE_ANSWER_COUNT + PROBE_DIVISION_COUNT);
  Buffer input(device, operands.size() * sizeof(float), BufferUse::storage);
  Buffer output(device, answers.size() * sizeof(std::uint32_t), BufferUse::storage);
  input.upload(device, std::as_bytes(std::span(operands)));
  const std::array<Binding, 2> bindings{Binding{0, &input}, Binding{1, &output}};
  const ComputePipeline pipeline(device, kProbeSpirv, bindings, 0, {});
  const BindingSet set(device, pipeline, bindings);
  const std::array<Dispatch, 1> dispatches{
      Dispatch{&pipeline, &set, {}, PROBE_DIVISION_COUNT / PROBE_GROUP_SIZE, 1, 1}};
  Submitter(device).run(dispatches);
  output.download(device, std::as_writable_bytes(std::span(answers)));
  return answers;
}

}  // namespace

std::string to_string(NanChoice choice) {
  switch (choice) {
    case NanChoice::number:
      return "the number";
    case NanChoice::first_operand:
      return "the first operand";
    case NanChoice::second_operand:
      return "the second operand";
    case NanChoice::nan:
      return "NaN";
    case NanChoice::other:
      break;
  }
  return "neither operand";
}

ProbeResult probe_device(const Device& device) {
  const std::vector<float> operands = make_operands();
  const std::vector<std::uint32_t> answers = run_probe(device, operands);
  const auto at = [&answers](std::uint32_t slot) { return std::bit_cast<float>(answers[slot]); };
  ProbeResult out;
  out.fma_is_fused = at(PROBE_FMA) != 0.0F;
  out.plain_sum_is_fused = at(PROBE_PLAIN_SUM) != 0.0F;
  out.precise_sum_is_fused = at(PROBE_PRECISE_SUM) != 0.0F;
  out.two_sum_survives = at(PROBE_TWO_SUM) == kTiny;
  out.precise_two_sum_survives = at(PROBE_TWO_SUM_PRECISE) == kTiny;
  out.denormals_kept_by_sum = at(PROBE_DENORMAL_SUM) == 2.0F * kDenormal;
  out.denormals_kept_by_product = at(PROBE_DENORMAL_PRODUCT) == 3.0F * kDenormal;
  out.isnan_works = answers[PROBE_ISNAN] == 1;
  out.min_of_nan = nan_choice(at(PROBE_MIN_NAN_FIRST), at(PROBE_MIN_NAN_SECOND));
  out.max_of_nan = nan_choice(at(PROBE_MAX_NAN_FIRST), at(PROBE_MAX_NAN_SECOND));
  out.max_division_error_ulps = max_division_error(operands, answers);
  out.float64 = device.description().float64;
  return out;
}

}  // namespace vernier
