#include "bvh/area_tree.h"

#include <algorithm>
#include <array>

#include "bvh/bin_split.h"
#include "bvh/box.h"
#include "bvh/median_split.h"
#include "bvh/sweep_split.h"
#include "bvh/work_queue.h"

namespace vernier {
namespace {

// Subtrees of up to this many triangles are built by one thread.
constexpr std::size_t kTaskSize = 4096;
// A way down is at most kMedianDepth + log2(2^31) nodes long, and leaves one subtree waiting at each.
constexpr std::size_t kLongestWay = kMedianDepth + 31 + 1;

// A range of two or more references that becomes the subtree with root `node`.
struct Subtree {
  std::size_t begin, end;
  std::uint32_t node;
  std::uint32_t depth;
  ReferenceBounds bounds;

  std::size_t size() const { return end - begin; }
};

class TreeBuilder {
 public:
  TreeBuilder(TriangleReference* references, std::size_t count, BinaryNode* nodes, float area_scale)
      : references_(references), nodes_(nodes), area_scale_(area_scale), queue_(count / kTaskSize + 2) {}

  // Splits the root on all threads together, then lets them take subtrees.
  void build(const Subtree& root, ThreadTeam& team, const CountDone& done) {
    Children children = make_node(root, &team);
    for (const Subtree& child : children) {
      if (child.size() > 1) {
        queue_.push(child);
      }
    }
    team.run(team.thread_count(), [&](std::size_t) {
      try {
        while (const std::optional<Subtree> subtree = queue_.take()) {
          const std::size_t placed = build_subtree(*subtree);
          if (done) done(placed);
          queue_.finish();
        }
      } catch (...) {
        queue_.give_up();
        throw;
      }
    });
  }

 private:
  using Children = std::array<Subtree, 2>;

  Split split(const Subtree& subtree, ThreadTeam* team) {
    const std::span<TriangleReference> references(references_ + subtree.begin, subtree.size());
    if (subtree.depth >= kMedianDepth) {
      return split_by_median(references, subtree.bounds);
    }
    if (references.size() <= kSweepLimit) {
      return split_by_sweep(references, area_scale_);
    }
    const std::optional<Split> split = split_by_bins(references, subtree.bounds, area_scale_, team);
    return split ? *split : split_by_median(references, subtree.bounds);
  }

  // A child of one reference is a leaf; a larger one has its nodes where BinaryTree says.
  Children make_node(const Subtree& subtree, ThreadTeam* team) {
    const Split halves = split(subtree, team);
    const std::size_t middle = subtree.begin + halves.middle;
    const auto right_node = subtree.node + static_cast<std::uint32_t>(halves.middle);
    const Children children = {Subtree{subtree.begin, middle, subtree.node + 1, subtree.depth + 1, halves.left},
                               Subtree{middle, subtree.end, right_node, subtree.depth + 1, halves.right}};
    nodes_[subtree.node] = {box_from(subtree.bounds.box), child_of(children[0]), child_of(children[1])};
    return children;
  }

  BinaryChild child_of(const Subtree& subtree) const {
    return subtree.size() == 1 ? kLeafBit | triangle_index(references_[subtree.begin]) : subtree.node;
  }

  // Where both halves are large the right one goes to the queue (at most count / kTaskSize times), others wait here.
  // Returns how many references became leaves.
  std::size_t build_subtree(const Subtree& first) {
    std::size_t placed = first.size();
    std::array<Subtree, kLongestWay> waiting;
    std::size_t waiting_count = 0;
    waiting[waiting_count++] = first;
    while (waiting_count > 0) {
      const Subtree subtree = waiting[--waiting_count];
      const Children children = make_node(subtree, nullptr);
      const bool both_are_large = std::min(children[0].size(), children[1].size()) > kTaskSize;
      if (both_are_large) {
        queue_.push(children[1]);
        placed -= children[1].size();
      } else if (children[1].size() > 1) {
        waiting[waiting_count++] = children[1];
      }
      if (children[0].size() > 1) {
        waiting[waiting_count++] = children[0];
      }
    }
    return placed;
  }

  TriangleReference* references_;
  BinaryNode* nodes_;
  float area_scale_;
  WorkQueue<Subtree> queue_;
};

}  // namespace

void fill_nodes_by_area(const TriangleReferences& references, BinaryNode* nodes, ThreadTeam& team,
                        const CountDone& done) {
  const float longest = longest_side(box_from(references.bounds.box));
  // Any scale would do that keeps products of sides inside float; the smallest normal side is enough of a floor.
  const float area_scale = 1.0f / std::max(longest, 0x1p-126f);
  TreeBuilder builder(references.all.data(), references.all.size(), nodes, area_scale);
  builder.build({0, references.all.size(), 0, 0, references.bounds}, team, done);
}

}  // namespace vernier
