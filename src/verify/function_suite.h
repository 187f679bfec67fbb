#pragma once

#include <functional>
#include <string>

#include "verify/function_kernel.h"
#include "verify/random.h"
#include "verify/tally.h"

namespace vernier {

/// How far an answer may be off, by level; the fast level promises nothing and is measured alone.
struct ErrorTarget {
  const char* unit;
  double robust;
  double exact;
};

/// Makes the operands of a sample, number `sample` of the case.
using DrawOperands = std::function<FunctionOperands(SampleRandom& random, std::uint64_t sample)>;
/// Error of an answer in the target's unit.
using ErrorOfCall = std::function<double(const FunctionOperands& operands, const FunctionAnswers& answers)>;
/// Whether an answer has the case's property.
using JudgeCall = std::function<bool(const FunctionOperands& operands, const FunctionAnswers& answers)>;

/// Calls VERIFY_* `function` once per sample of `setup`, in order, and measures each answer. `name` is the case's.
CaseResult measured_calls(const CaseSetup& setup, const char* name, std::uint32_t function, const ErrorTarget& target,
                          const DrawOperands& draw, const ErrorOfCall& error_of);
/// The same for a property that holds or not.
CaseResult judged_calls(const CaseSetup& setup, const char* name, std::uint32_t function, const DrawOperands& draw,
                        const JudgeCall& held);

/// The operands that VERIFY_* `function` reads, as hex floats with their names.
std::string operand_text(std::uint32_t function, const FunctionOperands& operands);

using WideVector = glm::vec<3, long double>;

/// Writes `v`, rounded to floats, from operand `first` on.
void put(FunctionOperands& operands, std::size_t first, const glm::dvec3& v);

/// The vector of wide numbers from operand or answer `first` on.
template <std::size_t count>
WideVector wide_vector(const std::array<float, count>& words, std::size_t first) {
  return {words[first], words[first + 1], words[first + 2]};
}

/// The largest difference of a component of `got` and `expected` in half ulps of 1; NaN where a difference is.
double half_ulps_apart(const WideVector& got, const WideVector& expected);

}  // namespace vernier
