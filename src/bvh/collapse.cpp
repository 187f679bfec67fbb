#include "bvh/collapse.h"

#include <algorithm>
#include <vector>

#include "bvh/box.h"

namespace vernier {
namespace {

// Subtrees of up to this many triangles are planned by one thread.
constexpr std::uint32_t kTaskSize = 2048;
// A way down is at most kMedianDepth + log2(2^24) nodes long, and leaves one subtree waiting at each.
constexpr std::size_t kLongestWay = kMedianDepth + 24 + 1;

// What a subtree costs as at most 1, 2 or 3 children: the sum of the areas of the wide nodes needed, relative to the
// root's, and how many records they and the triangles take.
struct SubtreeCost {
  std::array<float, kMaxChildren - 1> area;
  std::array<std::uint32_t, kMaxChildren - 1> record_count;
};

// The best way to divide `slots` children among the two sides of a binary node.
struct Division {
  float area;
  std::uint32_t left_slots;
  std::uint32_t record_count;
};

// Without branches: no processor foresees which side needs more.
Division divide(const SubtreeCost& left, const SubtreeCost& right, std::uint32_t slots) {
  Division best{left.area[0] + right.area[slots - 2], 1, 0};
  for (std::uint32_t left_slots = 2; left_slots < slots; ++left_slots) {
    const float area = left.area[left_slots - 1] + right.area[slots - left_slots - 1];
    best.left_slots = std::max(best.left_slots, area < best.area ? left_slots : 0u);
    best.area = std::min(best.area, area);
  }
  best.record_count = left.record_count[best.left_slots - 1] + right.record_count[slots - best.left_slots - 1];
  return best;
}

// `one` where `condition`, else `other`, without a branch.
std::uint32_t select(bool condition, std::uint32_t one, std::uint32_t other) {
  return other ^ ((one ^ other) & (condition ? ~0u : 0u));
}

// Subtrees that are planned and whose parents are not, the last one on top.
class PlannedSubtrees {
 public:
  /// What is below a node with half area `area`, whose sides are the uppermost, the left one's on top, as far as they
  /// are no leaves, becomes one subtree. As one child it is a wide node over at most four; as two or three children it
  /// may still be handed over as fewer, where that is no dearer.
  CollapsePlan join(const BinaryNode& node, float area) {
    const SubtreeCost& left = is_leaf(node.left) ? kLeaf : costs_[--count_];
    const SubtreeCost& right = is_leaf(node.right) ? kLeaf : costs_[--count_];
    const Division in_two = divide(left, right, 2);
    const Division in_three = divide(left, right, 3);
    const Division in_four = divide(left, right, 4);
    const float one = area + in_four.area;
    const float two = std::min(one, in_two.area);
    const std::uint32_t records_of_one = 1 + in_four.record_count;
    const std::uint32_t records_of_two = select(in_two.area < one, in_two.record_count, records_of_one);
    const bool opens_in_three = in_three.area < two;
    // Field by field: a whole one would be read back from memory before its parts are there.
    SubtreeCost& cost = costs_[count_++];
    cost.area[0] = one;
    cost.area[1] = two;
    cost.area[2] = std::min(two, in_three.area);
    cost.record_count[0] = records_of_one;
    cost.record_count[1] = records_of_two;
    cost.record_count[2] = select(opens_in_three, in_three.record_count, records_of_two);
    return {records_of_one << 6 | in_four.left_slots << 4 | select(opens_in_three, in_three.left_slots << 2, 0) |
            select(in_two.area < one, in_two.left_slots, 0)};
  }
  void push(const SubtreeCost& cost) { costs_[count_++] = cost; }
  const SubtreeCost& top() const { return costs_[count_ - 1]; }

 private:
  static constexpr SubtreeCost kLeaf = {{0.0f, 0.0f, 0.0f}, {1, 1, 1}};

  std::array<SubtreeCost, kLongestWay + 1> costs_;
  std::size_t count_ = 0;
};

CollapsePlan plan_node(const BinaryNode& node, double area_scale, PlannedSubtrees& planned) {
  return planned.join(node, static_cast<float>(half_area(node.box) * area_scale));
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

CollapsePlans plan_collapse(const BinaryTree& tree, ThreadTeam& team) {
  const double area_scale = 1.0 / half_area(tree.bounds);
  CollapsePlans plans(tree.leaf_count - 1);
  const std::vector<Part> parts = upper_parts(tree);
  std::vector<SubtreeCost> costs(parts.size());
  // The numbers of parents are lower than those of what is below them, so backwards every node finds its sides planned.
  team.run(parts.size(), [&](std::size_t i) {
    if (!parts[i].is_task()) return;
    PlannedSubtrees planned;
    for (std::uint32_t node = parts[i].node + parts[i].leaf_count - 1; node-- > parts[i].node;) {
      plans[node] = plan_node(tree.nodes[node], area_scale, planned);
    }
    costs[i] = planned.top();
  });
  PlannedSubtrees planned;
  for (std::size_t i = parts.size(); i-- > 0;) {
    if (parts[i].is_task()) {
      planned.push(costs[i]);
    } else {
      plans[parts[i].node] = plan_node(tree.nodes[parts[i].node], area_scale, planned);
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
