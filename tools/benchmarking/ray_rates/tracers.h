#pragma once

#include <memory>
#include <vector>

#include "../embree.h"
#include "gpu/submission.h"
#include "ray_sets.h"
#include "render/gpu_scene.h"
#include "verify/ray_kernel.h"

namespace vernier {

/// How long a pass took, and the CPU seconds of all threads meanwhile.
struct PassTime {
  double seconds;
  double cpu_s;
};

/// Embree's single rays on all threads.
class EmbreeTracer {
 public:
  /// Builds the tree over `mesh` by `quality`. `mesh` and `rays`, once given, outlive the tracer.
  EmbreeTracer(const RawMesh& mesh, RTCBuildQuality quality, unsigned thread_count);
  EmbreeTracer(EmbreeTracer&&) = delete;
  ~EmbreeTracer();

  /// What `ray` meets first.
  SurfaceHit closest_hit(const RatedRay& ray) const;
  /// One search for each of `rays`, on all threads.
  PassTime trace(const std::vector<RatedRay>& rays) const;
  /// The triangle that each ray meets first, or 0 where a ray that asks for any meets one; RATED_NOTHING: none.
  std::vector<std::uint32_t> answers(const std::vector<RatedRay>& rays) const;

 private:
  std::uint32_t search(const RatedRay& ray) const;

  RTCDevice device_ = nullptr;
  RTCScene scene_ = nullptr;
  unsigned thread_count_ = 1;
};

/// What a kind's rays cost in records, and how many rounds of its loop a subgroup makes.
struct RecordCounts {
  double records_per_ray;
  double rounds_per_subgroup;  ///< the mean over subgroups of the most records among its rays
};

/// traverse_bvh as it is compiled for renders, by device timestamps.
class VernierTracer {
 public:
  /// Builds the tree over `mesh` and puts it and `rays` on `device`, which outlives the tracer.
  VernierTracer(const Device& device, const RawMesh& mesh, const RaySets& rays);

  /// The tree.
  const Bvh& bvh() const { return scene_.bvh(); }
  /// One dispatch of all rays of `kind`.
  PassTime trace(RayKind kind);
  /// What the rays of `kind` meet.
  std::vector<RatedAnswer> answers(RayKind kind);
  /// By a pass that counts, which is not timed.
  RecordCounts count_records(RayKind kind);

 private:
  struct BoundSet {
    Buffer rays;
    BindingSet timed, counting;
  };
  std::vector<Binding> bindings_with(const Buffer& rays) const;
  ComputePipeline make_pipeline(bool count_cost, const Buffer& rays) const;
  std::vector<RatedAnswer> run(const ComputePipeline& pipeline, const BindingSet& set);

  const Device* device_;
  RayScene scene_;
  Buffer dispatch_, answers_;
  ComputePipeline timed_, counting_;
  std::vector<BoundSet> sets_;
  Submitter submitter_;
};

/// The use of buffers of rays and of answers on `device`.
BufferUse texel_use(const Device& device);

/// How long `dispatch` takes.
PassTime timed_pass(Submitter& submitter, const Dispatch& dispatch);

/// `answers` to `rays` as EmbreeTracer::answers has them. Throws Error for a search that was cut off.
std::vector<std::uint32_t> comparable(const std::vector<RatedAnswer>& answers, const std::vector<RatedRay>& rays);

}  // namespace vernier
