#include "render/trace_pipeline.h"

#include <algorithm>

#include "shared/effects.h"
#include "shared/specialization_ids.h"
#include "spirv/accumulate_storage.h"
#include "spirv/accumulate_texels.h"
#include "spirv/primary_queries.h"
#include "spirv/primary_storage.h"
#include "spirv/primary_texels.h"
#include "spirv/trace_queries.h"
#include "spirv/trace_storage.h"
#include "spirv/trace_texels.h"

namespace vernier {
namespace {

/// More waiting rays than that cost registers and memory in every lane; with the default cutoff weights die first.
constexpr std::uint32_t kLargestPathStack = 64;

std::span<const std::uint32_t> spirv_of(Kernel kernel, SceneLoads loads) {
  const auto by_loads = [loads](auto texels, auto storage, auto queries) {
    return loads == SceneLoads::texels ? texels : loads == SceneLoads::storage ? storage : queries;
  };
  switch (kernel) {
    case Kernel::trace:
      return by_loads(kTraceTexelsSpirv, kTraceStorageSpirv, kTraceQueriesSpirv);
    case Kernel::primary:
      return by_loads(kPrimaryTexelsSpirv, kPrimaryStorageSpirv, kPrimaryQueriesSpirv);
    case Kernel::accumulate:
      break;
  }
  return by_loads(kAccumulateTexelsSpirv, kAccumulateStorageSpirv, kAccumulateStorageSpirv);
}

}  // namespace

std::uint32_t levels_of(Accuracy accuracy) {
  switch (accuracy) {
    case Accuracy::fast:
      return LEVELS_OF(LEVEL_FAST);
    case Accuracy::robust:
      break;
    case Accuracy::exact:
      return LEVELS_OF(LEVEL_EXACT);
  }
  return LEVELS_OF(LEVEL_ROBUST);
}

std::uint32_t levels_of(const RenderSettings& settings) {
  return settings.spot_levels.value_or(levels_of(settings.accuracy));
}

std::uint32_t waiting_rays(std::uint32_t effects, std::uint32_t max_bounces) {
  const bool scatters = (effects & (EFFECT_REFLECTION | EFFECT_REFRACTION)) != 0;
  const bool splits = (effects & EFFECT_REFLECTION) != 0 && (effects & EFFECT_REFRACTION) != 0;
  const bool passes = (effects & (EFFECT_ALPHA_MASK | EFFECT_ALPHA_BLEND)) != 0;
  // One per depth for each way a ray can branch (shaders/trace_path.glsl, next_ray).
  const std::uint32_t per_depth = (splits ? 1u : 0u) + (passes && scatters ? 1u : 0u);
  return static_cast<std::uint32_t>(std::min<std::uint64_t>(std::uint64_t{per_depth} * max_bounces, kLargestPathStack));
}

TraceSpecialization specialize(std::uint32_t effects, const SceneShape& scene, std::uint32_t max_bounces,
                               bool count_cost, const DeviceDescription& device, TraversalForm form) {
  TraceSpecialization values;
  values.effects = effects;
  values.shift_stack = shifts_stack(device, form) && scene.depth <= SHIFT_STACK_MAX_SIZE;
  // An array has room to spare for nothing, and trees of other depths find the same kernel: SwiftShader compiles for
  // seconds.
  constexpr std::uint32_t kArrayStep = 16;
  const std::uint32_t depth = std::max(scene.depth, 1u);
  values.traversal_stack = values.shift_stack ? depth : (depth + kArrayStep - 1) / kArrayStep * kArrayStep;
  values.instanced = scene.instanced;
  values.coarse = scene.coarse;
  values.test_last = device.is_llvmpipe;
  values.workflows = scene.workflows;
  values.path_stack = waiting_rays(effects, max_bounces);
  values.count_cost = count_cost;
  return values;
}

std::vector<SpecializationValue> specialization_values(const TraceSpecialization& specialization) {
  return {{SPECIALIZATION_EFFECTS, specialization.effects},
          {SPECIALIZATION_TRAVERSAL_STACK, specialization.traversal_stack},
          {SPECIALIZATION_SHIFT_STACK, specialization.shift_stack ? 1u : 0u},
          {SPECIALIZATION_PATH_STACK, specialization.path_stack},
          {SPECIALIZATION_COUNT_COST, specialization.count_cost ? 1u : 0u},
          {SPECIALIZATION_COUNT_EFFECTS, specialization.count_effects ? 1u : 0u},
          {SPECIALIZATION_LISTED_PIXELS, specialization.listed_pixels ? 1u : 0u},
          {SPECIALIZATION_INSTANCED, specialization.instanced ? 1u : 0u},
          {SPECIALIZATION_COARSE, specialization.coarse ? 1u : 0u},
          {SPECIALIZATION_TEST_LAST, specialization.test_last ? 1u : 0u},
          {SPECIALIZATION_WORKFLOWS, specialization.workflows},
          {SPECIALIZATION_LEVELS, specialization.levels},
          {SPECIALIZATION_MUTATION, specialization.mutation}};
}

ComputePipeline make_trace_pipeline(const Device& device, Kernel kernel, SceneLoads loads,
                                    const TraceSpecialization& specialization, std::span<const Binding> bindings) {
  require_loads(device.description(), loads);
  TraceSpecialization of_kernel = specialization;
  of_kernel.count_effects = specialization.count_effects && kernel == Kernel::trace;
  return ComputePipeline(device, spirv_of(kernel, loads), bindings, 0, specialization_values(of_kernel));
}

std::string trace_spirv_hash(SceneLoads loads) {
  switch (loads) {
    case SceneLoads::texels:
      return std::string(kTraceTexelsSha256);
    case SceneLoads::queries:
      return std::string(kTraceQueriesSha256);
    case SceneLoads::storage:
      break;
  }
  return std::string(kTraceStorageSha256);
}

}  // namespace vernier
