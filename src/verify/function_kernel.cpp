#include "verify/function_kernel.h"

#include "gpu/buffer.h"
#include "gpu/compute_pipeline.h"
#include "gpu/submission.h"
#include "shared/specialization_ids.h"
#include "spirv/verify_boundary.h"
#include "spirv/verify_light.h"
#include "spirv/verify_surface.h"

namespace vernier {
namespace {

/// The kernel that calls the function. Several small ones: SwiftShader takes five seconds to compile all in one.
std::span<const std::uint32_t> module_of(std::uint32_t function) {
  switch (function) {
    case VERIFY_FRESNEL:
    case VERIFY_REFRACTION:
    case VERIFY_MIRROR:
    case VERIFY_SCHLICK:
    case VERIFY_PLATE:
      return kVerifyBoundarySpirv;
    case VERIFY_HIGHLIGHT:
    case VERIFY_LOG_ONE_MINUS:
    case VERIFY_LIGHT:
    case VERIFY_SUM:
      return kVerifyLightSpirv;
    default:
      return kVerifySurfaceSpirv;
  }
}

}  // namespace

std::vector<FunctionAnswers> call_shader_function(const CaseSetup& setup, std::uint32_t function,
                                                  std::span<const FunctionOperands> operands) {
  std::vector<FunctionAnswers> answers(operands.size());
  if (operands.empty()) return answers;
  const Device& device = *setup.device;
  Buffer operand_buffer(device, operands.size_bytes(), BufferUse::storage);
  operand_buffer.upload(device, std::as_bytes(operands));
  const Buffer answer_buffer(device, std::span(answers).size_bytes(), BufferUse::storage);
  const std::array<Binding, 2> bindings{Binding{0, &operand_buffer}, Binding{1, &answer_buffer}};
  const std::array<SpecializationValue, 3> values{SpecializationValue{SPECIALIZATION_LEVELS, setup.levels},
                                                  SpecializationValue{SPECIALIZATION_MUTATION, setup.mutation},
                                                  SpecializationValue{SPECIALIZATION_FUNCTION, function}};
  const ComputePipeline pipeline(device, module_of(function), bindings, 0, values);
  const BindingSet set(device, pipeline, bindings);
  constexpr std::uint32_t kWorkgroup = 64;
  const auto groups = static_cast<std::uint32_t>((operands.size() + kWorkgroup - 1) / kWorkgroup);
  const Dispatch dispatch{&pipeline, &set, {}, groups, 1, 1};
  Submitter(device).run({&dispatch, 1});
  answer_buffer.download(device, std::as_writable_bytes(std::span(answers)));
  return answers;
}

}  // namespace vernier
