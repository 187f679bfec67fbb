#pragma once

#include <array>
#include <span>
#include <vector>

#include "shared/verify_functions.h"
#include "verify/verify_case.h"

namespace vernier {

/// Operands of a call of a shader function, and its answers; unused ones are 0.
using FunctionOperands = std::array<float, VERIFY_OPERANDS>;
using FunctionAnswers = std::array<float, VERIFY_ANSWERS>;

/// Calls shader function VERIFY_* `function` on the device of `setup`, at its levels and with its mutation, once per
/// element of `operands`. Throws Error like any submission.
std::vector<FunctionAnswers> call_shader_function(const CaseSetup& setup, std::uint32_t function,
                                                  std::span<const FunctionOperands> operands);

}  // namespace vernier
