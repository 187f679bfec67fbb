#include "bvh/reinsertion.h"

#include <algorithm>
#include <array>
#include <bit>
#include <vector>

#include "bvh/box.h"

namespace vernier {
namespace {

// Subtrees whose new places one thread looks for at a time.
constexpr std::size_t kPiece = 256;
// Of the nodes, by area, those that are worth a search: the large ones are in the way of most rays.
constexpr std::size_t kSearchedShare = 4;
// Nodes that a search looks at, at most: where everything lies in everything it would go through the whole tree.
constexpr int kVisitLimit = 1024;
constexpr int kPasses = 4;

using NodeIndex = std::uint32_t;
constexpr NodeIndex kNone = ~NodeIndex{0};

// Inner nodes have the numbers that they have in the binary tree, leaves come after them.
struct LinkedNode {
  LaneBox box;
  float area;
  NodeIndex parent;
  std::array<NodeIndex, 2> children;  // a leaf: none, and its triangle

  bool is_leaf() const { return children[0] == kNone; }
};

// A subtree and the node whose sibling it had better be.
struct Move {
  float gain;
  NodeIndex subtree, target;
};

class LinkedTree {
 public:
  LinkedTree(const BinaryTree& tree, std::span<const BvhTriangle> triangles)
      : area_scale_(1.0f / std::max(longest_side(tree.bounds), 0x1p-126f)), nodes_(2 * tree.nodes.size() + 1) {
    auto leaf = static_cast<NodeIndex>(tree.nodes.size());
    nodes_[0].parent = kNone;
    for (NodeIndex i = 0; i < tree.nodes.size(); ++i) {
      const BinaryNode& node = tree.nodes[i];
      nodes_[i].children = {vernier::is_leaf(node.left) ? leaf++ : node.left,
                            vernier::is_leaf(node.right) ? leaf++ : node.right};
      set_box(i, lane_box(node.box));
      for (const int side : {0, 1}) {
        const BinaryChild child = side == 0 ? node.left : node.right;
        LinkedNode& below = nodes_[nodes_[i].children[side]];
        below.parent = i;
        if (!vernier::is_leaf(child)) continue;
        below.children = {kNone, leaf_triangle(child)};
        set_box(nodes_[i].children[side], lane_box(triangles[leaf_triangle(child)]));
      }
    }
  }

  // The largest ones that have a grandparent.
  std::vector<NodeIndex> large_subtrees() const {
    std::vector<NodeIndex> subtrees;
    for (NodeIndex i = 0; i < nodes_.size(); ++i) {
      if (i != root_ && nodes_[i].parent != root_) subtrees.push_back(i);
    }
    const auto count = static_cast<std::ptrdiff_t>(subtrees.size() / kSearchedShare);
    std::nth_element(subtrees.begin(), subtrees.begin() + count, subtrees.end(), [&](NodeIndex a, NodeIndex b) {
      return nodes_[a].area != nodes_[b].area ? nodes_[a].area > nodes_[b].area : a < b;
    });
    subtrees.resize(static_cast<std::size_t>(count));
    return subtrees;
  }

  // Looks under one ancestor after the other: `saved` is by how much the areas below it fall without the subtree.
  Move best_move(NodeIndex subtree, std::vector<std::pair<NodeIndex, float>>& waiting) const {
    Move best{0.0f, subtree, kNone};
    const LinkedNode& moved = nodes_[subtree];
    NodeIndex from = subtree;
    NodeIndex above = moved.parent;
    float saved = nodes_[above].area;
    LaneBox rest;
    int visits_left = kVisitLimit;
    while (above != kNone && visits_left > 0) {
      const NodeIndex sibling = sibling_of(from);
      waiting.push_back({sibling, saved});
      for (; !waiting.empty() && visits_left > 0; --visits_left) {
        const auto [target, saved_above] = waiting.back();
        waiting.pop_back();
        const LinkedNode& node = nodes_[target];
        const float gain = saved_above - joint_area(node.box, moved.box);
        if (gain > best.gain && target != sibling_of(subtree)) best = {gain, subtree, target};
        const float saved_here = gain + node.area;
        if (node.is_leaf() || saved_here - moved.area <= best.gain) continue;
        waiting.push_back({node.children[1], saved_here});
        waiting.push_back({node.children[0], saved_here});
      }
      waiting.clear();
      rest.grow(nodes_[sibling].box);
      if (from != subtree) saved += nodes_[above].area - scaled_half_area(rest, area_scale_);
      from = above;
      above = nodes_[above].parent;
      // Beside an ancestor it takes a node of that one's size.
      if (above != kNone && from != moved.parent && saved - nodes_[from].area > best.gain) {
        best = {saved - nodes_[from].area, subtree, from};
      }
    }
    return best;
  }

  void make(const Move& move) {
    const NodeIndex parent = nodes_[move.subtree].parent;
    const NodeIndex sibling = sibling_of(move.subtree);
    // Moves made before may have brought it there, or the target below it.
    if (parent == root_ || move.subtree == root_ || move.target == parent || move.target == sibling ||
        is_below(move.target, move.subtree)) {
      return;
    }
    if (put_beside(move.subtree, move.target) >= 0.0) put_beside(move.subtree, sibling);
  }

  // Writes the nodes in the order of BinaryTree; false where a leaf has more than `depth_limit` nodes above it.
  bool write(BinaryTree& tree, std::uint32_t depth_limit) const {
    LargeArray<BinaryNode> nodes(tree.nodes.size());
    struct Waiting {
      NodeIndex node;
      std::uint32_t depth;
      BinaryChild* link;
    };
    BinaryChild root;
    std::vector<Waiting> waiting = {{root_, 0, &root}};
    BinaryChild next = 0;
    while (!waiting.empty()) {
      const auto [index, depth, link] = waiting.back();
      waiting.pop_back();
      const LinkedNode& node = nodes_[index];
      if (depth > depth_limit) return false;
      *link = node.is_leaf() ? kLeafBit | node.children[1] : next++;
      if (node.is_leaf()) continue;
      BinaryNode& written = nodes[*link];
      written.box = box_from(node.box);
      waiting.push_back({node.children[1], depth + 1, &written.right});
      waiting.push_back({node.children[0], depth + 1, &written.left});
    }
    tree.nodes.swap(nodes);
    return true;
  }

 private:
  void set_box(NodeIndex index, const LaneBox& box) {
    nodes_[index].box = box;
    nodes_[index].area = scaled_half_area(box, area_scale_);
  }

  float joint_area(const LaneBox& a, const LaneBox& b) const {
    LaneBox joint = a;
    joint.grow(b);
    return scaled_half_area(joint, area_scale_);
  }

  NodeIndex sibling_of(NodeIndex index) const {
    const auto& children = nodes_[nodes_[index].parent].children;
    return children[0] == index ? children[1] : children[0];
  }

  bool is_below(NodeIndex index, NodeIndex ancestor) const {
    while (index != kNone && index != ancestor) index = nodes_[index].parent;
    return index == ancestor;
  }

  void replace_child(NodeIndex parent, NodeIndex child, NodeIndex by) {
    nodes_[by].parent = parent;
    if (parent == kNone) {
      root_ = by;
    } else {
      nodes_[parent].children[nodes_[parent].children[0] == child ? 0 : 1] = by;
    }
  }

  // Returns by how much the areas grow from `index` up.
  double refit(NodeIndex index) {
    double growth = 0.0;
    for (; index != kNone; index = nodes_[index].parent) {
      LaneBox box = nodes_[nodes_[index].children[0]].box;
      box.grow(nodes_[nodes_[index].children[1]].box);
      growth -= nodes_[index].area;
      set_box(index, box);
      growth += nodes_[index].area;
    }
    return growth;
  }

  // Moves `subtree`, with its parent as the new one of both. Returns by how much the areas grow.
  double put_beside(NodeIndex subtree, NodeIndex target) {
    const NodeIndex parent = nodes_[subtree].parent;
    const NodeIndex grandparent = nodes_[parent].parent;
    replace_child(grandparent, parent, sibling_of(subtree));
    double growth = refit(grandparent);
    replace_child(nodes_[target].parent, target, parent);
    nodes_[target].parent = parent;
    nodes_[parent].children = {target, subtree};
    growth += refit(parent);
    return growth;
  }

  float area_scale_;
  NodeIndex root_ = 0;
  std::vector<LinkedNode> nodes_;
};

std::vector<Move> find_moves(const LinkedTree& tree, ThreadTeam& team) {
  const std::vector<NodeIndex> subtrees = tree.large_subtrees();
  std::vector<Move> moves(subtrees.size());
  team.run((subtrees.size() + kPiece - 1) / kPiece, [&](std::size_t piece) {
    std::vector<std::pair<NodeIndex, float>> waiting;
    for (std::size_t i = piece * kPiece; i < std::min((piece + 1) * kPiece, subtrees.size()); ++i) {
      moves[i] = tree.best_move(subtrees[i], waiting);
    }
  });
  std::erase_if(moves, [](const Move& move) { return move.target == kNone; });
  std::ranges::sort(
      moves, [](const Move& a, const Move& b) { return a.gain != b.gain ? a.gain > b.gain : a.subtree < b.subtree; });
  return moves;
}

}  // namespace

void reinsert_subtrees(BinaryTree& tree, std::span<const BvhTriangle> triangles, ThreadTeam& team) {
  LinkedTree linked(tree, triangles);
  for (int pass = 0; pass < kPasses; ++pass) {
    for (const Move& move : find_moves(linked, team)) linked.make(move);
  }
  linked.write(tree, kMedianDepth + static_cast<std::uint32_t>(std::bit_width(tree.leaf_count - 1u)));
}

}  // namespace vernier
