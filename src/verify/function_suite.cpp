#include "verify/function_suite.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "verify/level_bound.h"

namespace vernier {
namespace {

/// A float or a vector among the operands of a function.
struct OperandName {
  const char* name;
  std::size_t width;  ///< 1 to 3 words
};

/// In the order of shared/verify_functions.h.
std::vector<OperandName> operand_names(std::uint32_t function) {
  switch (function) {
    case VERIFY_FRESNEL:
      return {{"cosine", 1}, {"eta", 1}};
    case VERIFY_HIGHLIGHT:
      return {{"normal", 3}, {"to_light", 3}, {"to_viewer", 3}, {"exponent", 1}};
    case VERIFY_UNIT_VECTOR:
      return {{"v", 3}};
    case VERIFY_REFRACTION:
    case VERIFY_PLATE:
      return {{"to_viewer", 3}, {"normal", 3}, {"eta", 1}};
    case VERIFY_MIRROR:
      return {{"to_viewer", 3}, {"normal", 3}, {"geometric_normal", 3}};
    case VERIFY_SCHLICK:
      return {{"cosine", 1}};
    case VERIFY_LOG_ONE_MINUS:
      return {{"s", 1}};
    case VERIFY_TEXTURE:
      return {{"u", 1}, {"v", 1}, {"width", 1}, {"height", 1}, {"wrap", 1}, {"filter", 1}};
    case VERIFY_LIGHT:
      return {{"light.position", 3},  {"light.kind", 1},      {"light.direction", 3},  {"light.range", 1},
              {"light.intensity", 1}, {"light.cos_outer", 1}, {"light.cone_scale", 1}, {"point", 3}};
    case VERIFY_CAMERA:
      return {{"right", 3}, {"up", 3}, {"forward", 3}, {"width", 1}, {"height", 1}, {"x", 1}, {"y", 1}};
    case VERIFY_SUM:
      return {{"even", 1}, {"odd", 1}, {"count", 1}, {"start_low", 3}, {"start_high", 3}, {"odd_green", 1}};
    case VERIFY_UV:
      return {{"uv0", 2}, {"uv1", 2}, {"uv2", 2}, {"b1", 1}, {"b2", 1}};
    case VERIFY_FRAME:
      return {{"uv0", 2}, {"uv1", 2}, {"uv2", 2}, {"e1", 3}, {"e2", 3}, {"normal", 3}};
    case VERIFY_NORMAL:
      return {{"n0", 3}, {"n1", 3}, {"n2", 3}, {"b1", 1}, {"b2", 1}, {"geometric_normal", 3}};
    default:
      return {};
  }
}

/// Draws all samples, calls the function and books each with `book`.
CaseResult called(const CaseSetup& setup, const char* name, std::uint32_t function, Tally tally,
                  const DrawOperands& draw,
                  const std::function<void(Tally&, const FunctionOperands&, const FunctionAnswers&)>& book) {
  std::vector<FunctionOperands> operands(setup.sample_count);
  for (std::uint64_t i = 0; i < setup.sample_count; ++i) {
    SampleRandom random(setup.seed, name, i);
    operands[i] = draw(random, i);
  }
  const std::vector<FunctionAnswers> answers = call_shader_function(setup, function, operands);
  for (std::size_t i = 0; i < operands.size(); ++i) book(tally, operands[i], answers[i]);
  return tally.result();
}

}  // namespace

std::string operand_text(std::uint32_t function, const FunctionOperands& operands) {
  constexpr const char* kAxes[] = {".x", ".y", ".z"};
  std::vector<std::pair<std::string, float>> values;
  std::size_t word = 0;
  for (const OperandName& one : operand_names(function)) {
    for (std::size_t axis = 0; axis < one.width; ++axis) {
      values.emplace_back(std::string(one.name) + (one.width > 1 ? kAxes[axis] : ""), operands[word++]);
    }
  }
  return hex_floats(values);
}

CaseResult measured_calls(const CaseSetup& setup, const char* name, std::uint32_t function, const ErrorTarget& target,
                          const DrawOperands& draw, const ErrorOfCall& error_of) {
  return called(setup, name, function, Tally(target.unit, level_bound(setup, target.robust, target.exact)), draw,
                [&](Tally& tally, const FunctionOperands& o, const FunctionAnswers& a) {
                  tally.book_error(error_of(o, a), [&] { return operand_text(function, o); });
                });
}

CaseResult judged_calls(const CaseSetup& setup, const char* name, std::uint32_t function, const DrawOperands& draw,
                        const JudgeCall& held) {
  return called(setup, name, function, Tally(), draw,
                [&](Tally& tally, const FunctionOperands& o, const FunctionAnswers& a) {
                  tally.book(held(o, a), [&] { return operand_text(function, o); });
                });
}

void put(FunctionOperands& operands, std::size_t first, const glm::dvec3& v) {
  for (int axis = 0; axis < 3; ++axis) operands[first + static_cast<std::size_t>(axis)] = static_cast<float>(v[axis]);
}

double half_ulps_apart(const WideVector& got, const WideVector& expected) {
  double largest = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    const double apart = static_cast<double>(std::abs(got[axis] - expected[axis])) / 0x1p-24;
    if (std::isnan(apart)) return apart;
    largest = std::max(largest, apart);
  }
  return largest;
}

}  // namespace vernier
