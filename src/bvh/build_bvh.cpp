#include "bvh/build_bvh.h"

#include <string>
#include <utility>

#include "bvh/binary_tree.h"
#include "bvh/build_progress.h"
#include "bvh/collapse.h"
#include "bvh/encode_bvh.h"
#include "error.h"
#include "math/parallel_for.h"
#include "shared/bvh_record.h"

namespace vernier {
namespace {

// A tree of n triangles has n triangle records and at least n / 4 nodes, so more than this need not be tried. Also
// keeps indices clear of kLeafBit.
void refuse_too_many(std::size_t triangle_count) {
  if (triangle_count > BVH_MAX_RECORDS) {
    throw Error(ErrorKind::refused, "scene: " + std::to_string(triangle_count) + " triangles, more than the " +
                                        std::to_string(BVH_MAX_RECORDS) +
                                        " records of a BVH hold; simplify or split the model");
  }
}

}  // namespace

Bvh build_bvh(std::span<const BvhTriangle> triangles, const std::function<bool(std::uint32_t)>& not_opaque,
              unsigned thread_count, BuildMethod method, const std::function<void(double)>& progress) {
  refuse_too_many(triangles.size());
  ThreadTeam team(resolve_thread_count(thread_count));
  BuildProgress done(progress, triangles.size());
  // As many records as are ever needed: the builder works in their memory, and what is not touched costs nothing.
  LargeArray<BvhRecord> records(2 * triangles.size());
  static_assert(kWorkspaceBytes <= 2 * sizeof(BvhRecord));
  const Workspace workspace(std::as_writable_bytes(std::span(records)));
  const BinaryTree tree = build_binary_tree(triangles, method, team, workspace, done.tree_stage());
  const CollapsePlans plans = tree.leaf_count > 1 ? plan_collapse(tree, team) : CollapsePlans();
  return encode_bvh(tree, plans, triangles, not_opaque, team, done.record_stage(), std::move(records));
}

}  // namespace vernier
