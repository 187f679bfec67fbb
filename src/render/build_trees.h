#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "bvh/build_method.h"
#include "bvh/bvh.h"
#include "render/bake_instances.h"
#include "render/plan_instances.h"

namespace vernier {

/// The BVH of a scene, and where its shared meshes lie.
struct SceneTrees {
  Bvh bvh;
  std::vector<std::uint32_t> instances;  ///< DeviceInstance as words, the scene itself first; empty: no mesh is shared
  std::uint64_t traced_triangles = 0;    ///< of all instances, in the BVH
  std::uint64_t hidden_triangles = 0;  ///< of all instances, left out since they lie exactly on opaque ones before them
};

/// Builds the tree over what `baked` has copied and, once for each, over the meshes that `plan` shares, which are added
/// to the arrays of `baked`; its corners are used up. Without a method, and with no mesh shared, the triangles alone.
/// Triangle records name their place in baked.triangles by word 7 where meshes are shared, else by word 11. `space` is
/// the traced space; the rest as in build_bvh.
SceneTrees build_trees(const Scene& scene, const InstancePlan& plan, const TracedSpace& space, BakedScene& baked,
                       unsigned thread_count, std::optional<BuildMethod> method,
                       const std::function<void(double share)>& progress);

}  // namespace vernier
