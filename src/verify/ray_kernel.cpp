#include "verify/ray_kernel.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <stdexcept>

#include "bvh/build_bvh.h"
#include "bvh/decode_record.h"
#include "bvh/triangle_record.h"
#include "shared/bindings.h"
#include "shared/specialization_ids.h"
#include "spirv/verify_rays_queries.h"
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

/// How kernels read the scene that go by `form`; for ray queries RayKernel brings a driver's tree that fits its rays.
SceneLoads loads_of_tree(const Device& device, TraversalForm form) {
  const SceneLoads loads = choose_scene_loads(device.description(), form);
  return loads == SceneLoads::queries ? SceneLoads::storage : loads;
}

/// The triangles of a tree without its nodes, and the driver's tree over them.
struct DriverScene {
  Buffer records;
  DriverTree tree;
};

DriverScene driver_scene(const Device& device, const Bvh& bvh, std::span<const RayQuery> queries) {
  std::vector<BvhRecord> records;
  std::ranges::copy_if(bvh.records, std::back_inserter(records), is_triangle);
  glm::vec3 reach(0.0f);
  for (const RayQuery& query : queries) {
    if (std::isfinite(glm::length(query.origin))) reach = glm::max(reach, glm::abs(query.origin));
  }
  DriverScene scene{Buffer(device, std::span(records).size_bytes(), BufferUse::storage),
                    driver_tree(device, records, std::max({reach.x, reach.y, reach.z}))};
  scene.records.upload(device, std::as_bytes(std::span(records)));
  return scene;
}

std::span<const std::uint32_t> ray_spirv(SceneLoads loads) {
  return loads == SceneLoads::texels    ? kVerifyRaysTexelsSpirv
         : loads == SceneLoads::queries ? kVerifyRaysQueriesSpirv
                                        : kVerifyRaysStorageSpirv;
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

RayScene::RayScene(const Device& device, std::span<const BvhTriangle> triangles, TraversalForm form)
    : RayScene(device, packed_triangles(triangles), form) {}

RayScene::RayScene(const Device& device, PackedScene packed, TraversalForm form)
    : packed_(std::move(packed)), gpu_(device, packed_, loads_of_tree(device, form)) {
  gpu_.set_constants(device, packed_.constants, packed_.steering);
}

DispatchConstants RayScene::constants() const {
  DispatchConstants constants{};
  constants.steering = gpu_.steering();
  return constants;
}

const ComputePipeline& RayKernel::pipeline_for(const RayScene& scene, std::span<const Binding> bindings) {
  const DeviceDescription& device = setup_.device->description();
  TraceSpecialization specialization = specialize(0, scene.shape(), 0, true, device, setup_.traversal);
  specialization.levels = setup_.levels;
  specialization.mutation = setup_.mutation;
  const std::tuple key{specialization.traversal_stack, specialization.instanced, specialization.coarse};
  const auto found = by_shape_.find(key);
  if (found != by_shape_.end()) return found->second;
  std::vector<SpecializationValue> values = specialization_values(specialization);
  values.push_back({SPECIALIZATION_FUNCTION, function_});
  ComputePipeline pipeline(*setup_.device, ray_spirv(choose_scene_loads(device, setup_.traversal)), bindings, 0,
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
  std::optional<DriverScene> of_driver;
  if (choose_scene_loads(device.description(), setup_.traversal) == SceneLoads::queries) {
    of_driver = driver_scene(device, scene.bvh(), queries);
    std::ranges::find(bindings, std::uint32_t{BINDING_RECORDS}, &Binding::binding)->buffer = &of_driver->records;
    bindings.push_back({.binding = BINDING_BOX_TREE, .tree = &of_driver->tree});
  }
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
  std::vector<BvhRecord> records;
  for (const BvhTriangle& triangle : triangles) records.push_back(triangle_record(triangle, false));
  return records;
}

}  // namespace vernier
