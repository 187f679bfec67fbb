#include <algorithm>
#include <ctime>
#include <stdexcept>

#include "error.h"
#include "render/trace_pipeline.h"
#include "shared/bindings.h"
#include "spirv/searches_storage.h"
#include "spirv/searches_texels.h"
#include "tracers.h"

namespace vernier {

BufferUse texel_use(const Device& device) {
  return choose_scene_loads(device.description()) == SceneLoads::texels ? BufferUse::texels_rgba32ui
                                                                        : BufferUse::storage;
}

PassTime timed_pass(Submitter& submitter, const Dispatch& dispatch) {
  const std::clock_t cpu_start = std::clock();
  constexpr double kSecondsPerMs = 1e-3;
  const double seconds = submitter.run({&dispatch, 1}).device_ms * kSecondsPerMs;
  return {seconds, static_cast<double>(std::clock() - cpu_start) / CLOCKS_PER_SEC};
}

std::vector<std::uint32_t> comparable(const std::vector<RatedAnswer>& answers, const std::vector<RatedRay>& rays) {
  std::vector<std::uint32_t> found(answers.size());
  for (std::size_t i = 0; i < answers.size(); ++i) {
    if (answers[i].finished == 0) throw Error(ErrorKind::failed, "the driver cut a search off");
    found[i] = rays[i].any_hit != 0 && answers[i].triangle != RATED_NOTHING ? 0 : answers[i].triangle;
  }
  return found;
}

VernierTracer::VernierTracer(const Device& device, const RawMesh& mesh, const RaySets& rays)
    : device_(&device),
      scene_(device, triangles_of(mesh)),
      dispatch_(device, sizeof(DispatchConstants), BufferUse::storage),
      answers_(device, kRayCount * sizeof(RatedAnswer), texel_use(device)),
      submitter_(device) {
  const DispatchConstants constants = scene_.constants();
  dispatch_.upload(device, std::as_bytes(std::span(&constants, 1)));
  for (const std::vector<RatedRay>& kind : rays) {
    const std::span<const std::byte> bytes = std::as_bytes(std::span(kind));
    Buffer buffer(device, bytes.size(), texel_use(device));
    buffer.upload(device, bytes);
    if (sets_.empty()) {
      timed_ = make_pipeline(false, buffer);
      counting_ = make_pipeline(true, buffer);
    }
    BindingSet timed(device, timed_, bindings_with(buffer));
    BindingSet counting(device, counting_, bindings_with(buffer));
    sets_.push_back({std::move(buffer), std::move(timed), std::move(counting)});
  }
}

std::vector<Binding> VernierTracer::bindings_with(const Buffer& rays) const {
  std::vector<Binding> all = scene_.on_device().bindings();
  all.push_back({BINDING_DISPATCH, &dispatch_});
  all.push_back({BINDING_RATED_RAYS, &rays});
  all.push_back({BINDING_RATED_ANSWERS, &answers_});
  return all;
}

ComputePipeline VernierTracer::make_pipeline(bool count_cost, const Buffer& rays) const {
  const std::vector<SpecializationValue> values =
      specialization_values(specialize(0, scene_.shape(), 0, count_cost, device_->description()));
  const bool texels = texel_use(*device_) == BufferUse::texels_rgba32ui;
  return {*device_, texels ? kSearchesTexelsSpirv : kSearchesStorageSpirv, bindings_with(rays), 0, values};
}

PassTime VernierTracer::trace(RayKind kind) {
  return timed_pass(submitter_, {&timed_, &sets_[kind].timed, {}, kRayCount / RATED_GROUP});
}

std::vector<RatedAnswer> VernierTracer::run(const ComputePipeline& pipeline, const BindingSet& set) {
  const Dispatch dispatch{&pipeline, &set, {}, kRayCount / RATED_GROUP};
  submitter_.run({&dispatch, 1});
  std::vector<RatedAnswer> answers(kRayCount);
  answers_.download(*device_, std::as_writable_bytes(std::span(answers)));
  return answers;
}

std::vector<RatedAnswer> VernierTracer::answers(RayKind kind) {
  return run(timed_, sets_[kind].timed);
}

RecordCounts VernierTracer::count_records(RayKind kind) {
  const std::vector<RatedAnswer> answers = run(counting_, sets_[kind].counting);
  const std::size_t width = std::max(1u, device_->description().subgroup_size);
  double records = 0.0, rounds = 0.0;
  for (std::size_t first = 0; first < answers.size(); first += width) {
    std::uint32_t most = 0;
    for (std::size_t i = first; i < first + width; ++i) {
      records += answers[i].records;
      most = std::max(most, answers[i].records);
    }
    rounds += most;
  }
  const auto count = static_cast<double>(answers.size());
  return {records / count, rounds * static_cast<double>(width) / count};
}

}  // namespace vernier
