#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "gpu/compute_pipeline.h"
#include "gpu/submission.h"
#include "render/gpu_scene.h"
#include "render/trace_pipeline.h"
#include "shared/verify_rays.h"
#include "verify/verify_case.h"

namespace vernier {

/// The ray from `origin` along `direction`, all of it: t in (0, LARGEST_FLOAT).
RayQuery ray_query(const glm::vec3& origin, const glm::vec3& direction);

/// The same, as hex floats for a report.
std::string ray_inputs(const RayQuery& query);

/// Triangles on the device as a render has them: the BVH and what shading a hit reads. Owns its buffers.
class RayScene {
 public:
  /// Builds the BVH over `triangles`, whose ids are below their count, and uploads it with one blank material, for rays
  /// that go by `form`.
  RayScene(const Device& device, std::span<const BvhTriangle> triangles, TraversalForm form = TraversalForm::automatic);
  /// Uploads a packed scene, with our tree whatever `form` is.
  RayScene(const Device& device, PackedScene packed, TraversalForm form = TraversalForm::automatic);

  /// The tree over the triangles.
  const Bvh& bvh() const { return packed_.bvh; }
  /// What kernels are compiled for.
  SceneShape shape() const { return shape_of(packed_); }
  /// Its buffers.
  const GpuScene& on_device() const { return gpu_; }
  /// What every dispatch carries.
  DispatchConstants constants() const;

 private:
  PackedScene packed_;
  GpuScene gpu_;
};

/// Traces rays with traverse_bvh as it is compiled for renders. Compiles once per depth of a BVH, which is the size of
/// the traversal stack, with and without instances. `setup.device` outlives it.
class RayKernel {
 public:
  /// For one of VERIFY_CLOSEST, VERIFY_ALL_HITS, VERIFY_RESPAWN, at the levels and with the mutation of `setup`.
  RayKernel(const CaseSetup& setup, std::uint32_t function) : setup_(setup), function_(function) {}

  /// One answer per query, in order. Throws Error like any submission.
  std::vector<RayAnswer> trace(const RayScene& scene, std::span<const RayQuery> queries);

 private:
  const ComputePipeline& pipeline_for(const RayScene& scene, std::span<const Binding> bindings);

  CaseSetup setup_;
  std::uint32_t function_;
  std::map<std::tuple<std::uint32_t, bool, bool>, ComputePipeline> by_shape_;  // of the BVH
};

/// Tests rays against records without a traversal (verify_triangles.comp): VERIFY_TRIANGLES against every one of them,
/// which are triangles; VERIFY_BOXES against the children of the first, a node. `setup.device` outlives it.
class RecordKernel {
 public:
  /// At the levels and with the mutation of `setup`.
  RecordKernel(const CaseSetup& setup, std::uint32_t function) : setup_(setup), function_(function) {}

  /// One answer per query, in order. 1 to 2^15 records. Throws Error like any submission.
  std::vector<RayAnswer> test(std::span<const BvhRecord> records, std::span<const RayQuery> queries);

 private:
  CaseSetup setup_;
  std::uint32_t function_;
  std::optional<ComputePipeline> pipeline_;
};

/// `triangles` as records of their own, without boxes.
std::vector<BvhRecord> triangle_records(std::span<const BvhTriangle> triangles);

}  // namespace vernier
