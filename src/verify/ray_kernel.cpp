#include "verify/ray_kernel.h"

#include <bit>
#include <limits>
#include <stdexcept>

#include "bvh/build_bvh.h"
#include "render/pack_materials.h"
#include "shared/bindings.h"
#include "shared/bvh_record.h"
#include "shared/specialization_ids.h"
#include "spirv/verify_rays_storage.h"
#include "spirv/verify_rays_texels.h"
#include "spirv/verify_triangles.h"
#include "verify/tally.h"

namespace vernier {
namespace {

constexpr std::uint32_t kWorkgroup = 64;

/// Rays of one dispatch: the buffers stay small and no dispatch nears a driver's time limit.
constexpr std::size_t kChunk = 1u << 16;

PackedScene packed_triangles(std::span<const BvhTriangle> triangles) {
  PackedScene packed;
  packed.bvh = build_bvh(triangles, {}, 0);
  packed.first_triangles.assign(1, 0);
  packed.steering.object_count = 1;
  packed.steering.one = 1;
  packed.materials.assign(4 * MATERIAL_TEXELS, 0);
  packed.steering.environment_texture = NONE;
  packed.steering.triangle_count = packed.bvh.triangle_count;
  packed.steering.normal_texel = packed.steering.uv01_texel = packed.steering.uv23_texel = NONE;
  packed.steering.color_texel = packed.steering.tangent_texel = NONE;
  return packed;
}

/// Runs `pipeline_of(bindings)` over the queries, a chunk at a time.
template <typename PipelineOf>
std::vector<RayAnswer> answers_of(const Device& device, std::vector<Binding> bindings,
                                  std::span<const RayQuery> queries, const PipelineOf& pipeline_of) {
  std::vector<RayAnswer> answers(queries.size());
  for (std::size_t first = 0; first < queries.size(); first += kChunk) {
    const std::size_t count = std::min(kChunk, queries.size() - first);
    Buffer query_buffer(device, count * sizeof(RayQuery), BufferUse::storage);
    query_buffer.upload(device, std::as_bytes(queries.subspan(first, count)));
    const Buffer answer_buffer(device, count * sizeof(RayAnswer), BufferUse::storage);
    std::vector<Binding> all = bindings;
    all.push_back({BINDING_QUERIES, &query_buffer});
    all.push_back({BINDING_ANSWERS, &answer_buffer});
    const ComputePipeline& pipeline = pipeline_of(all);
    const BindingSet set(device, pipeline, all);
    const Dispatch dispatch{&pipeline, &set, {}, static_cast<std::uint32_t>((count + kWorkgroup - 1) / kWorkgroup)};
    Submitter(device).run({&dispatch, 1});
    answer_buffer.download(device, std::as_writable_bytes(std::span(answers).subspan(first, count)));
  }
  return answers;
}

}  // namespace

RayQuery ray_query(const glm::vec3& origin, const glm::vec3& direction) {
  return {origin, 0.0f, direction, std::numeric_limits<float>::max(), direction, NONE, 0};
}

std::string ray_inputs(const RayQuery& query) {
  return hex_floats({{"origin.x", query.origin.x},
                     {"origin.y", query.origin.y},
                     {"origin.z", query.origin.z},
                     {"direction.x", query.direction.x},
                     {"direction.y", query.direction.y},
                     {"direction.z", query.direction.z},
                     {"t_min", query.t_min},
                     {"t_max", query.t_max},
                     {"outgoing.x", query.outgoing.x},
                     {"outgoing.y", query.outgoing.y},
                     {"outgoing.z", query.outgoing.z}});
}

RayScene::RayScene(const Device& device, std::span<const BvhTriangle> triangles)
    : RayScene(device, packed_triangles(triangles)) {}

RayScene::RayScene(const Device& device, PackedScene packed)
    : packed_(std::move(packed)), gpu_(device, packed_, choose_scene_loads(device.description())) {
  gpu_.set_constants(device, packed_.constants, packed_.steering);
}

DispatchConstants RayScene::constants() const {
  DispatchConstants constants{};
  constants.steering = gpu_.steering();
  return constants;
}

const ComputePipeline& RayKernel::pipeline_for(const RayScene& scene, std::span<const Binding> bindings) {
  const DeviceDescription& device = setup_.device->description();
  const TraceSpecialization stack = specialize(0, scene.shape(), 0, true, device);
  const std::pair key{stack.traversal_stack, stack.instanced};
  const auto found = by_shape_.find(key);
  if (found != by_shape_.end()) return found->second;
  const std::vector<SpecializationValue> values{{SPECIALIZATION_EFFECTS, stack.effects},
                                                {SPECIALIZATION_TRAVERSAL_STACK, stack.traversal_stack},
                                                {SPECIALIZATION_SHIFT_STACK, stack.shift_stack ? 1u : 0u},
                                                {SPECIALIZATION_INSTANCED, stack.instanced ? 1u : 0u},
                                                {SPECIALIZATION_COUNT_COST, 1u},
                                                {SPECIALIZATION_LEVELS, setup_.levels},
                                                {SPECIALIZATION_MUTATION, setup_.mutation},
                                                {SPECIALIZATION_FUNCTION, function_}};
  const bool texels = choose_scene_loads(device) == SceneLoads::texels;
  ComputePipeline pipeline(*setup_.device, texels ? kVerifyRaysTexelsSpirv : kVerifyRaysStorageSpirv, bindings, 0,
                           values);
  return by_shape_.emplace(key, std::move(pipeline)).first->second;
}

std::vector<RayAnswer> RayKernel::trace(const RayScene& scene, std::span<const RayQuery> queries) {
  const Device& device = *setup_.device;
  const DispatchConstants constants = scene.constants();
  Buffer dispatch_buffer(device, sizeof(constants), BufferUse::storage);
  dispatch_buffer.upload(device, std::as_bytes(std::span(&constants, 1)));
  std::vector<Binding> bindings = scene.on_device().bindings();
  bindings.push_back({BINDING_DISPATCH, &dispatch_buffer});
  return answers_of(device, bindings, queries,
                    [&](std::span<const Binding> all) -> const ComputePipeline& { return pipeline_for(scene, all); });
}

std::vector<RayAnswer> RecordKernel::test(std::span<const BvhRecord> records, std::span<const RayQuery> queries) {
  // Above that llvmpipe's limit of 65535 rounds would cut the loop over the records off.
  constexpr std::size_t kMostRecords = 1u << 15;
  if (records.empty() || records.size() > kMostRecords) throw std::logic_error("RecordKernel: number of records");
  const Device& device = *setup_.device;
  Buffer record_buffer(device, records.size_bytes(), BufferUse::storage);
  record_buffer.upload(device, std::as_bytes(records));
  const std::vector<SpecializationValue> values{{SPECIALIZATION_LEVELS, setup_.levels},
                                                {SPECIALIZATION_MUTATION, setup_.mutation},
                                                {SPECIALIZATION_FUNCTION, function_}};
  return answers_of(device, {{BINDING_CORNERS, &record_buffer}}, queries,
                    [&](std::span<const Binding> all) -> const ComputePipeline& {
                      if (!pipeline_) pipeline_.emplace(device, kVerifyTrianglesSpirv, all, 0, values);
                      return *pipeline_;
                    });
}

std::vector<BvhRecord> triangle_records(std::span<const BvhTriangle> triangles) {
  const auto bits = [](float value) { return std::bit_cast<std::uint32_t>(value); };
  std::vector<BvhRecord> records;
  for (const BvhTriangle& t : triangles) {
    records.push_back({bits(t.v0.x), bits(t.v0.y), bits(t.v0.z), BVH_TRIANGLE, bits(t.v1.x), bits(t.v1.y), bits(t.v1.z),
                       0, bits(t.v2.x), bits(t.v2.y), bits(t.v2.z), t.id});
  }
  return records;
}

}  // namespace vernier
