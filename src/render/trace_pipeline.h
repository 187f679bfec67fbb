#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "gpu/compute_pipeline.h"
#include "render/gpu_scene.h"
#include "render/render_settings.h"
#include "shared/accuracy.h"
#include "shared/material_flags.h"
#include "shared/render_constants.h"

namespace vernier {

/// What the kernels are specialized to.
struct TraceSpecialization {
  std::uint32_t effects = 0;          ///< OR of EFFECT_*
  std::uint32_t traversal_stack = 1;  ///< entries, the depth of the BVH or more
  bool shift_stack = false;           ///< traversal stack in shifted registers
  std::uint32_t path_stack = 0;       ///< rays that can wait
  bool count_cost = false;
  bool count_effects = false;                      ///< trace kernel only
  bool listed_pixels = false;                      ///< dispatches have a list of their pixels
  bool instanced = false;                          ///< the BVH has instances
  bool coarse = false;                             ///< rays pad its boxes by one bound each (bvh/coarse.h)
  bool test_last = false;                          ///< loops test for their end behind their body
  std::uint32_t workflows = ALL_WORKFLOWS;         ///< those of the scene's materials
  std::uint32_t levels = LEVELS_OF(LEVEL_ROBUST);  ///< numeric level of each spot (shared/accuracy.h)
  std::uint32_t mutation = MUTATION_NONE;          ///< seeded fault; a renderer has none
};

/// What a kernel has to know of a scene when it is compiled.
struct SceneShape {
  std::uint32_t depth = 0;                  ///< of its BVH
  bool instanced = false;                   ///< its BVH has instances
  bool coarse = false;                      ///< its BVH is coarse (bvh/coarse.h)
  std::uint32_t workflows = ALL_WORKFLOWS;  ///< OR of 1 << WORKFLOW_*: those of its materials at least
};

/// That of `packed`.
inline SceneShape shape_of(const PackedScene& packed) {
  return {packed.bvh.depth, packed.bvh.instance_count > 0, packed.bvh.coarse, packed.workflows};
}

/// The levels of all spots at `accuracy`.
std::uint32_t levels_of(Accuracy accuracy);
/// Those that `settings` ask for.
std::uint32_t levels_of(const RenderSettings& settings);

/// Names of SPOT_*, by number.
inline constexpr std::array<const char*, SPOT_COUNT> kSpotNames{"box",     "triangle", "position", "spawn",
                                                                "fresnel", "specular", "sum"};

/// Rays of a path that can wait at a time where `effects` run, at most `max_bounces` deep: none where no ray branches.
/// Up to 64; beyond that they are dropped and counted.
std::uint32_t waiting_rays(std::uint32_t effects, std::uint32_t max_bounces);

/// The specialization for `scene` with `effects`, at most `max_bounces` deep, on `device`. A stack that
/// is deeper than there are variables to shift is an array, whatever `form` says.
TraceSpecialization specialize(std::uint32_t effects, const SceneShape& scene, std::uint32_t max_bounces,
                               bool count_cost, const DeviceDescription& device,
                               TraversalForm form = TraversalForm::automatic);

/// The constants of kernels that search, for all of `specialization`. Those that a module does not have are passed
/// over.
std::vector<SpecializationValue> specialization_values(const TraceSpecialization& specialization);

/// Which kernel.
enum class Kernel {
  trace,       ///< samples of a pass
  accumulate,  ///< traced samples into the film
  primary      ///< AOVs at pixel centres
};

/// Compiles `kernel` for buffers that are bound like `bindings`. Throws Error(refused) where the device lacks what
/// kernels with `loads` need.
ComputePipeline make_trace_pipeline(const Device& device, Kernel kernel, SceneLoads loads,
                                    const TraceSpecialization& specialization, std::span<const Binding> bindings);

/// SHA-256 of the trace kernel's SPIR-V.
std::string trace_spirv_hash(SceneLoads loads);

}  // namespace vernier
