#include "bvh/collapse.h"

#include <vector>

#include "bvh/box.h"
#include "math/parallel_for.h"

namespace vernier {
namespace {

// Subtrees of up to this many triangles are planned by one thread.
constexpr std::uint32_t kTaskSize = 2048;
// A way down is at most kMedianDepth + log2(2^24) nodes long, and leaves one subtree waiting at each.
constexpr std::size_t kLongestWay = kMedianDepth + 24 + 1;

// What a subtree costs as at most 1, 2 or 3 children: the sum of the areas of the wide nodes needed, relative to the
// root's, and how many records they and the triangles take.
struct SubtreeCost {
  std::array<float, kMaxChildren - 1> area = {0.0f, 0.0f, 0.0f};
  std::array<std::uint32_t, kMaxChildren - 1> record_count = {1, 1, 1};
};

// The best way to divide `slots` children among the two sides of a binary node.
struct Division {
  float area;
  std::uint32_t left_slots;
  std::uint32_t record_count;
};

// Without branches: no processor foresees which side needs more.
Division divide(const SubtreeCost& left, const SubtreeCost& right, std::uint32_t slots) {
  Division best{left.area[0] + right.area[slots - 2], 1, left.record_count[0] + right.record_count[slots - 2]};
  for (std::uint32_t left_slots = 2; left_slots < slots; ++left_slots) {
    const float area = left.area[left_slots - 1] + right.area[slots - left_slots - 1];
    const std::uint32_t record_count = left.record_count[left_slots - 1] + right.record_count[slots - left_slots - 1];
    const bool better = area < best.area;
    best = {better ? area : best.area, better ? left_slots : best.left_slots,
            better ? record_count : best.record_count};
  }
  return best;
}

// Fills `plan` of a node with half area `area`. A node as one child is a wide node over at most four; as two or three
// children it may still be handed over as fewer, where that is no dearer.
SubtreeCost plan_node(float area, const SubtreeCost& left, const SubtreeCost& right, CollapsePlan& plan) {
  const Division inside = divide(left, right, kMaxChildren);
  SubtreeCost cost;
  cost.area[0] = area + inside.area;
  cost.record_count[0] = 1 + inside.record_count;
  std::uint32_t divisions = inside.left_slots << 2 * (kMaxChildren - 2);
  for (std::uint32_t slots = 2; slots < kMaxChildren; ++slots) {
    const Division division = divide(left, right, slots);
    const bool opened = division.area < cost.area[slots - 2];
    cost.area[slots - 1] = opened ? division.area : cost.area[slots - 2];
    cost.record_count[slots - 1] = opened ? division.record_count : cost.record_count[slots - 2];
    divisions |= opened ? division.left_slots << 2 * (slots - 2) : 0;
  }
  plan.bits = cost.record_count[0] << 6 | divisions;
  return cost;
}

// Subtrees that are planned and whose parents are not, the last one on top.
class PlannedSubtrees {
 public:
  void push(const SubtreeCost& cost) { costs_[count_++] = cost; }
  SubtreeCost pop() { return costs_[--count_]; }

 private:
  std::array<SubtreeCost, kLongestWay + 1> costs_;
  std::size_t count_ = 0;
};

// The plans of both sides are the uppermost in `planned`, the left one's on top, as far as they are no leaves.
void plan_next(const BinaryNode& node, double area_scale, PlannedSubtrees& planned, CollapsePlan& plan) {
  const SubtreeCost left = is_leaf(node.left) ? SubtreeCost() : planned.pop();
  const SubtreeCost right = is_leaf(node.right) ? SubtreeCost() : planned.pop();
  planned.push(plan_node(static_cast<float>(half_area(node.box) * area_scale), left, right, plan));
}

// A node above the subtrees that one thread plans, or the root of such a subtree.
struct Part {
  std::uint32_t node, leaf_count;

  bool is_task() const { return leaf_count <= kTaskSize; }
};

// Parents first, then what is on their left, in the order of the nodes' numbers.
std::vector<Part> upper_parts(const BinaryTree& tree) {
  std::vector<Part> parts;
  std::vector<Part> waiting = {{tree.root, tree.leaf_count}};
  while (!waiting.empty()) {
    const Part part = waiting.back();
    waiting.pop_back();
    parts.push_back(part);
    if (part.is_task()) continue;
    const BinaryNode& node = tree.nodes[part.node];
    const std::uint32_t left_count = left_leaf_count(node, part.node, part.leaf_count);
    if (!is_leaf(node.right)) waiting.push_back({node.right, part.leaf_count - left_count});
    if (!is_leaf(node.left)) waiting.push_back({node.left, left_count});
  }
  return parts;
}

void open_node(const BinaryTree& tree, const CollapsePlans& plans, WideChildren::Child side, std::uint32_t slots,
               WideChildren& wide);

// Adds to `wide` the children that a side with `slots` of them hands over.
void gather(const BinaryTree& tree, const CollapsePlans& plans, WideChildren::Child side, std::uint32_t slots,
            WideChildren& wide) {
  if (!is_leaf(side.child)) {
    while (slots > 1 && left_slots(plans[side.child], slots) == 0) --slots;
  }
  if (is_leaf(side.child) || slots == 1) {
    wide.children[wide.count++] = side;
    return;
  }
  open_node(tree, plans, side, slots, wide);
}

void open_node(const BinaryTree& tree, const CollapsePlans& plans, WideChildren::Child side, std::uint32_t slots,
               WideChildren& wide) {
  const BinaryNode& node = tree.nodes[side.child];
  const std::uint32_t to_the_left = left_slots(plans[side.child], slots);
  const std::uint32_t left_count = left_leaf_count(node, side.child, side.leaf_count);
  gather(tree, plans, {node.left, left_count}, to_the_left, wide);
  gather(tree, plans, {node.right, side.leaf_count - left_count}, slots - to_the_left, wide);
}

}  // namespace

CollapsePlans plan_collapse(const BinaryTree& tree, unsigned thread_count) {
  const double area_scale = 1.0 / half_area(tree.bounds);
  CollapsePlans plans(tree.leaf_count - 1);
  const std::vector<Part> parts = upper_parts(tree);
  std::vector<SubtreeCost> costs(parts.size());
  // The numbers of parents are lower than those of what is below them, so backwards every node finds its sides planned.
  parallel_for(thread_count, parts.size(), [&](std::size_t i) {
    if (!parts[i].is_task()) return;
    PlannedSubtrees planned;
    for (std::uint32_t node = parts[i].node + parts[i].leaf_count - 1; node-- > parts[i].node;) {
      plan_next(tree.nodes[node], area_scale, planned, plans[node]);
    }
    costs[i] = planned.pop();
  });
  PlannedSubtrees planned;
  for (std::size_t i = parts.size(); i-- > 0;) {
    if (parts[i].is_task()) {
      planned.push(costs[i]);
    } else {
      plan_next(tree.nodes[parts[i].node], area_scale, planned, plans[parts[i].node]);
    }
  }
  return plans;
}

WideChildren wide_children(const BinaryTree& tree, const CollapsePlans& plans, std::uint32_t node,
                           std::uint32_t leaf_count) {
  WideChildren wide;
  open_node(tree, plans, {node, leaf_count}, kMaxChildren, wide);
  return wide;
}

}  // namespace vernier
