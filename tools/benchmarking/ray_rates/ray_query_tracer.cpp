#include "ray_query_tracer.h"

#include <array>

#include "spirv/ray_queries_storage.h"
#include "spirv/ray_queries_texels.h"

namespace vernier {

RayQueryTracer::RayQueryTracer(const Device& device, const RawMesh& mesh, const RaySets& rays)
    : device_(&device),
      tree_(device, mesh.positions, mesh.corners),
      answers_(device, kRayCount * sizeof(RatedAnswer), texel_use(device)),
      submitter_(device) {
  const bool texels = texel_use(device) == BufferUse::texels_rgba32ui;
  const std::span<const std::uint32_t> spirv = texels ? kRayQueriesTexelsSpirv : kRayQueriesStorageSpirv;
  for (const std::vector<RatedRay>& kind : rays) {
    Buffer& buffer = rays_.emplace_back(device, std::as_bytes(std::span(kind)).size(), texel_use(device));
    buffer.upload(device, std::as_bytes(std::span(kind)));
    const std::vector<Binding> bindings = {{.binding = BINDING_RATED_RAYS, .buffer = &buffer},
                                           {.binding = BINDING_RATED_ANSWERS, .buffer = &answers_},
                                           {.binding = BINDING_RATED_SCENE, .tree = &tree_}};
    if (sets_.empty()) {
      closest_ = ComputePipeline(device, spirv, bindings, 0, std::array{SpecializationValue{RATED_ANY_HIT, 0}});
      any_ = ComputePipeline(device, spirv, bindings, 0, std::array{SpecializationValue{RATED_ANY_HIT, 1}});
    }
    sets_.emplace_back(device, closest_, bindings);
  }
}

PassTime RayQueryTracer::trace(RayKind kind) {
  return timed_pass(submitter_, {kind == kShadow ? &any_ : &closest_, &sets_[kind], {}, kRayCount / RATED_GROUP});
}

std::vector<RatedAnswer> RayQueryTracer::answers(RayKind kind) {
  trace(kind);
  std::vector<RatedAnswer> found(kRayCount);
  answers_.download(*device_, std::as_writable_bytes(std::span(found)));
  return found;
}

}  // namespace vernier
