#pragma once

#include <vector>

#include "gpu/driver_tree.h"
#include "tracers.h"

namespace vernier {

/// The driver's own traversal and triangle test, VK_KHR_ray_query, by device timestamps.
class RayQueryTracer {
 public:
  /// Has the driver build its tree over `mesh`, and puts `rays` beside it. `device`, which outlives the tracer, has ray
  /// queries.
  RayQueryTracer(const Device& device, const RawMesh& mesh, const RaySets& rays);

  /// One dispatch of all rays of `kind`.
  PassTime trace(RayKind kind);
  /// What the rays of `kind` meet.
  std::vector<RatedAnswer> answers(RayKind kind);

 private:
  const Device* device_;
  DriverTree tree_;
  Buffer answers_;
  ComputePipeline closest_, any_;
  std::vector<Buffer> rays_;
  std::vector<BindingSet> sets_;
  Submitter submitter_;
};

}  // namespace vernier
