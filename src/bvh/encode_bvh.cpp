#include "bvh/encode_bvh.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "bvh/box.h"
#include "bvh/quantize_node.h"
#include "bvh/triangle_record.h"
#include "error.h"
#include "shared/bvh_record.h"

namespace vernier {
namespace {

// Subtrees of up to this many triangles are written by one thread.
constexpr std::uint32_t kTaskSize = 2048;

// Subtrees of up to this many triangles have all of them prefetched: 20 KiB, which the nearest cache holds.
constexpr std::uint32_t kPrefetched = 512;

void prefetch(const BvhTriangle& triangle) {
  __builtin_prefetch(&triangle.v0);
  __builtin_prefetch(&triangle.id);
}

// A wide node to be written: its binary node, its own record, the first record of what is below it.
struct Task {
  BinaryChild node;
  std::uint32_t leaf_count;
  std::uint32_t record;
  std::uint32_t first_below;
  std::uint32_t depth;  // nodes from the root to this one, both counted
  bool prefetched;      // the triangles below
};

class Encoder {
 public:
  Encoder(const BinaryTree& tree, const CollapsePlans& plans, std::span<const BvhTriangle> triangles,
          const std::function<bool(std::uint32_t)>& not_opaque, LargeArray<BvhRecord>& records)
      : tree_(tree),
        plans_(plans),
        triangles_(triangles),
        not_opaque_(not_opaque),
        records_(records),
        scene_extent_(longest_side(tree.bounds)) {}

  // Writes one node and its triangles, and adds its inner children to `tasks`, the first one last.
  void write_node(const Task& task, std::vector<Task>& tasks) const {
    const WideChildren wide = children_of(task);
    std::array<LaneBox, kMaxChildren> boxes;
    LaneBox node_box;
    std::uint32_t first_below = task.first_below + wide.count;
    const std::size_t tasks_before = tasks.size();
    for (std::uint32_t i = 0; i < wide.count; ++i) {
      const auto [child, leaf_count] = wide.children[i];
      const std::uint32_t record = task.first_below + i;
      LaneBox box;
      if (is_leaf(child)) {
        const BvhTriangle& triangle = triangles_[leaf_triangle(child)];
        box = lane_box(triangle);
        records_[record] = triangle_record(triangle, not_opaque_ && not_opaque_(triangle.id));
      } else {
        box = lane_box(tree_.nodes[child].box);
        tasks.push_back({child, leaf_count, record, first_below, task.depth + 1, task.prefetched});
        first_below += record_count(plans_, child) - 1;
      }
      node_box.grow(box);
      boxes[i] = padded(box);
    }
    std::reverse(tasks.begin() + static_cast<std::ptrdiff_t>(tasks_before), tasks.end());
    records_[task.record] =
        quantize_node(std::span<const LaneBox>(boxes).first(wide.count), padded(node_box), task.first_below);
  }

  // Asks for the triangles below `task`, which lie all over memory, before each is waited for in turn.
  void prefetch_triangles(const Task& task) const {
    if (is_leaf(task.node)) return;
    const std::span nodes = std::span(tree_.nodes).subspan(task.node, task.leaf_count - 1);
    for (const BinaryNode& node : nodes) {
      for (const BinaryChild child : {node.left, node.right}) {
        if (is_leaf(child)) prefetch(triangles_[leaf_triangle(child)]);
      }
    }
  }

  // Writes everything below `first`; returns the number of nodes on the longest way from the root.
  std::uint32_t write_subtree(const Task& first) const {
    std::uint32_t depth = 0;
    std::vector<Task> waiting = {first};
    while (!waiting.empty()) {
      Task task = waiting.back();
      waiting.pop_back();
      depth = std::max(depth, task.depth);
      if (!task.prefetched && task.leaf_count <= kPrefetched) {
        prefetch_triangles(task);
        task.prefetched = true;
      }
      write_node(task, waiting);
    }
    return depth;
  }

 private:
  WideChildren children_of(const Task& task) const {
    if (!is_leaf(task.node)) {
      return wide_children(tree_, plans_, task.node, task.leaf_count);
    }
    WideChildren single;
    single.children[single.count++] = {task.node, 1};
    return single;
  }

  LaneBox padded(const LaneBox& box) const { return pad_box(box, scene_extent_); }

  const BinaryTree& tree_;
  const CollapsePlans& plans_;
  std::span<const BvhTriangle> triangles_;
  const std::function<bool(std::uint32_t)>& not_opaque_;
  LargeArray<BvhRecord>& records_;
  float scene_extent_;
};

std::uint32_t count_records(const BinaryTree& tree, const CollapsePlans& plans) {
  // A leaf as root is a node and a triangle.
  const std::uint32_t count = is_leaf(tree.root) ? 2 : record_count(plans, tree.root);
  if (count > BVH_MAX_RECORDS) {
    throw Error(ErrorKind::refused, "scene: " + std::to_string(tree.leaf_count) + " triangles need " +
                                        std::to_string(count) + " BVH records, more than " +
                                        std::to_string(BVH_MAX_RECORDS) + "; simplify or split the model");
  }
  return count;
}

/// Writes the nodes above the subtrees that a thread each will write, and returns these; `depth` becomes the number of
/// nodes on the longest way through what is written.
std::vector<Task> write_upper(const Encoder& encoder, const BinaryTree& tree, std::uint32_t& depth) {
  std::vector<Task> upper = {{tree.root, tree.leaf_count, 0, 1, 1, false}};
  std::vector<Task> subtrees;
  while (!upper.empty()) {
    const Task task = upper.back();
    upper.pop_back();
    if (task.leaf_count <= kTaskSize) {
      subtrees.push_back(task);
    } else {
      depth = std::max(depth, task.depth);
      encoder.write_node(task, upper);
    }
  }
  return subtrees;
}

}  // namespace

Bvh encode_bvh(const BinaryTree& tree, const CollapsePlans& plans, std::span<const BvhTriangle> triangles,
               const std::function<bool(std::uint32_t)>& not_opaque, ThreadTeam& team, const CountDone& done,
               LargeArray<BvhRecord> memory) {
  Bvh bvh;
  if (tree.leaf_count == 0) {
    return bvh;
  }
  bvh.records = std::move(memory);
  bvh.records.resize(count_records(tree, plans));
  bvh.bounds = tree.bounds;
  bvh.triangle_count = tree.leaf_count;
  bvh.node_count = static_cast<std::uint32_t>(bvh.records.size()) - tree.leaf_count;
  bvh.sah_cost = tree.sah_cost;
  bvh.coarse = tree.coarse;

  const Encoder encoder(tree, plans, triangles, not_opaque, bvh.records);
  const std::vector<Task> subtrees = write_upper(encoder, tree, bvh.depth);
  std::vector<std::uint32_t> depths(subtrees.size());
  team.run(subtrees.size(), [&](std::size_t i) {
    depths[i] = encoder.write_subtree(subtrees[i]);
    if (done) done(subtrees[i].leaf_count);
  });
  for (const std::uint32_t depth : depths) {
    bvh.depth = std::max(bvh.depth, depth);
  }
  return bvh;
}

}  // namespace vernier
