#include "render/build_trees.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "bvh/build_bvh.h"
#include "bvh/hidden_triangles.h"
#include "bvh/instance_tree.h"
#include "bvh/triangle_record.h"
#include "render/append_words.h"
#include "render/device_instance.h"
#include "shared/render_constants.h"

namespace vernier {
namespace {

bool lets_light_pass(const Material& material) {
  const glm::vec3& t = material.transmission;
  return material.alpha_mode != AlphaMode::opaque || t.x > 0.0f || t.y > 0.0f || t.z > 0.0f;
}

/// Tells `progress` the share of all trees, one tree after the other.
class TreeProgress {
 public:
  TreeProgress(std::function<void(double)> tell, std::uint64_t triangles)
      : tell_(std::move(tell)), share_per_triangle_(1.0 / static_cast<double>(std::max<std::uint64_t>(triangles, 1))) {}

  /// For a tree of so many triangles.
  std::function<void(double)> next(std::uint64_t triangles) {
    const double first = done_, share = static_cast<double>(triangles) * share_per_triangle_;
    done_ += share;
    if (!tell_) return {};
    return [this, first, share](double part) { tell_(first + share * part); };
  }

 private:
  std::function<void(double)> tell_;
  double share_per_triangle_;
  double done_ = 0.0;
};

/// The trees of the shared meshes, and what was left out of each.
struct SharedTrees {
  std::vector<ObjectTree> trees;
  std::vector<std::vector<Box>> boxes;
  std::vector<std::uint64_t> traced, hidden;
};

SharedTrees build_shared(const Scene& scene, const InstancePlan& plan, BakedScene& baked, unsigned thread_count,
                         BuildMethod method, TreeProgress& progress) {
  SharedTrees shared;
  for (std::size_t i = 0; i < plan.meshes.size(); ++i) {
    const Mesh& mesh = scene.meshes[plan.meshes[i]];
    const auto first_place = static_cast<std::uint32_t>(baked.triangles.size() / 4);
    std::vector<BvhTriangle> corners = bake_shared_mesh(mesh, plan.spaces[i], baked);
    const auto not_opaque = [&](std::uint32_t id) {
      return lets_light_pass(scene.materials[mesh.triangle_materials[id]]);
    };
    shared.hidden.push_back(remove_hidden(corners, not_opaque, thread_count));
    shared.trees.push_back(
        {build_bvh(corners, not_opaque, thread_count, method, progress.next(mesh.triangles.size())), first_place});
    shared.traced.push_back(shared.trees.back().bvh.triangle_count);
    shared.boxes.push_back(upper_boxes(shared.trees.back().bvh));
  }
  return shared;
}

/// The shared meshes' instances, and which of the meshes they use.
struct PlacedMeshes {
  std::vector<TreeInstance> instances;
  std::vector<bool> used;
};

/// Notes what the device has to know of each instance in `trees`, and counts its triangles there.
PlacedMeshes place_meshes(const Scene& scene, const InstancePlan& plan, const TracedSpace& space,
                          const BakedScene& baked, const SharedTrees& shared, SceneTrees& trees) {
  PlacedMeshes placed{{}, std::vector<bool>(plan.meshes.size(), false)};
  append_words(trees.instances, world_instance());
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    const std::uint32_t object = plan.place[i];
    if (object == NONE || shared.boxes[object].empty()) continue;
    const DeviceInstance instance =
        device_instance(scene.instances[i].world_from_object, plan.spaces[object], space, baked.first_triangles[i]);
    append_words(trees.instances, instance);
    const auto number = static_cast<std::uint32_t>(placed.instances.size() + 1);
    placed.instances.push_back({instance_box(instance, shared.boxes[object]), object, number});
    trees.traced_triangles += shared.traced[object];
    trees.hidden_triangles += shared.hidden[object];
    placed.used[object] = true;
  }
  return placed;
}

}  // namespace

SceneTrees build_trees(const Scene& scene, const InstancePlan& plan, const TracedSpace& space, BakedScene& baked,
                       unsigned thread_count, std::optional<BuildMethod> method,
                       const std::function<void(double share)>& progress) {
  const auto not_opaque = [&](std::uint32_t id) {
    return lets_light_pass(scene.materials[baked.triangles[4 * id + 3]]);
  };
  SceneTrees trees;
  trees.hidden_triangles = remove_hidden(baked.corners, not_opaque, thread_count);
  if (plan.meshes.empty()) {
    trees.bvh = method ? build_bvh(baked.corners, not_opaque, thread_count, *method, progress)
                       : list_triangles(baked.corners, not_opaque);
    trees.traced_triangles = trees.bvh.triangle_count;
    baked.corners = {};
    return trees;
  }
  TreeProgress tree_progress(progress, plan.stored_triangles + plan.shared_instances);
  SharedTrees shared = build_shared(scene, plan, baked, thread_count, *method, tree_progress);
  const PlacedMeshes placed = place_meshes(scene, plan, space, baked, shared, trees);
  const std::uint64_t copied = baked.corners.size();
  trees.bvh = build_instance_tree(std::move(baked.corners), baked.numbers, placed.instances, shared.trees, not_opaque,
                                  thread_count, *method, tree_progress.next(copied + placed.instances.size()));
  baked.corners = {};
  // The tree has those of a shared mesh once.
  trees.traced_triangles += trees.bvh.triangle_count;
  for (std::size_t i = 0; i < shared.traced.size(); ++i) {
    if (placed.used[i]) trees.traced_triangles -= shared.traced[i];
  }
  return trees;
}

}  // namespace vernier
