#include "bvh/collapse.h"

#include <vector>

#include "bvh/box.h"
#include "math/parallel_for.h"

namespace vernier {
namespace {

// Subtrees of up to this many triangles are planned by one thread.
constexpr std::uint32_t kTaskSize = 8192;

// The best way to divide `slots` children among the two sides of a binary node.
struct Division {
  float cost;
  std::uint32_t left_slots;
};

float cost_of(const CollapsePlans& plans, BinaryChild child, std::uint32_t slots) {
  return is_leaf(child) ? 0.0f : plans[child].cost[slots - 1];
}

std::uint32_t records_of(const CollapsePlans& plans, BinaryChild child, std::uint32_t slots) {
  return is_leaf(child) ? 1 : plans[child].record_count[slots - 1];
}

Division best_division(const BinaryNode& node, const CollapsePlans& plans, std::uint32_t slots) {
  Division best{cost_of(plans, node.left, 1) + cost_of(plans, node.right, slots - 1), 1};
  for (std::uint32_t left_slots = 2; left_slots < slots; ++left_slots) {
    const float cost = cost_of(plans, node.left, left_slots) + cost_of(plans, node.right, slots - left_slots);
    if (cost < best.cost) {
      best = {cost, left_slots};
    }
  }
  return best;
}

// The plans of both sides are made. A node as one child is a wide node over at most four; as two or three children it
// may still be handed over as fewer, where that is no dearer.
CollapsePlan plan_node(const BinaryNode& node, const CollapsePlans& plans, double area_scale) {
  const auto records = [&](const Division& division, std::uint32_t slots) {
    return records_of(plans, node.left, division.left_slots) +
           records_of(plans, node.right, slots - division.left_slots);
  };
  const Division inside = best_division(node, plans, kMaxChildren);
  CollapsePlan plan;
  plan.cost[0] = static_cast<float>(half_area(node.box) * area_scale) + inside.cost;
  plan.record_count[0] = 1 + records(inside, kMaxChildren);
  for (std::uint32_t slots = 2; slots < kMaxChildren; ++slots) {
    const Division division = best_division(node, plans, slots);
    const bool opened = division.cost < plan.cost[slots - 2];
    plan.cost[slots - 1] = opened ? division.cost : plan.cost[slots - 2];
    plan.record_count[slots - 1] = opened ? records(division, slots) : plan.record_count[slots - 2];
  }
  return plan;
}

struct Range {
  std::uint32_t node, leaf_count;
};

// Parents before children: their numbers fall from right to left, so backwards every plan finds its sides made.
void split_into_tasks(const BinaryTree& tree, std::vector<Range>& tasks, std::vector<std::uint32_t>& upper_nodes) {
  std::vector<Range> waiting = {{tree.root, tree.leaf_count}};
  while (!waiting.empty()) {
    const Range range = waiting.back();
    waiting.pop_back();
    if (range.leaf_count <= kTaskSize) {
      tasks.push_back(range);
      continue;
    }
    upper_nodes.push_back(range.node);
    const BinaryNode& node = tree.nodes[range.node];
    const std::uint32_t left_count = left_leaf_count(node, range.node, range.leaf_count);
    if (!is_leaf(node.left)) {
      waiting.push_back({node.left, left_count});
    }
    if (!is_leaf(node.right)) {
      waiting.push_back({node.right, range.leaf_count - left_count});
    }
  }
}

// Adds to `wide` the children that a side with `slots` of them hands over.
void gather(const BinaryTree& tree, const CollapsePlans& plans, WideChildren::Child side, std::uint32_t slots,
            WideChildren& wide) {
  if (!is_leaf(side.child)) {
    const CollapsePlan& plan = plans[side.child];
    while (slots > 1 && plan.cost[slots - 1] == plan.cost[slots - 2]) {
      --slots;
    }
  }
  if (is_leaf(side.child) || slots == 1) {
    wide.children[wide.count++] = side;
    return;
  }
  const BinaryNode& node = tree.nodes[side.child];
  const std::uint32_t left_slots = best_division(node, plans, slots).left_slots;
  const std::uint32_t left_count = left_leaf_count(node, side.child, side.leaf_count);
  gather(tree, plans, {node.left, left_count}, left_slots, wide);
  gather(tree, plans, {node.right, side.leaf_count - left_count}, slots - left_slots, wide);
}

}  // namespace

CollapsePlans plan_collapse(const BinaryTree& tree, unsigned thread_count) {
  const double area_scale = 1.0 / half_area(tree.bounds);
  CollapsePlans plans(tree.leaf_count - 1);
  std::vector<Range> tasks;
  std::vector<std::uint32_t> upper_nodes;
  split_into_tasks(tree, tasks, upper_nodes);
  parallel_for(thread_count, tasks.size(), [&](std::size_t i) {
    for (std::uint32_t node = tasks[i].node + tasks[i].leaf_count - 1; node-- > tasks[i].node;) {
      plans[node] = plan_node(tree.nodes[node], plans, area_scale);
    }
  });
  for (std::size_t i = upper_nodes.size(); i-- > 0;) {
    plans[upper_nodes[i]] = plan_node(tree.nodes[upper_nodes[i]], plans, area_scale);
  }
  return plans;
}

WideChildren wide_children(const BinaryTree& tree, const CollapsePlans& plans, std::uint32_t node,
                           std::uint32_t leaf_count) {
  const BinaryNode& top = tree.nodes[node];
  const std::uint32_t left_slots = best_division(top, plans, kMaxChildren).left_slots;
  const std::uint32_t left_count = left_leaf_count(top, node, leaf_count);
  WideChildren wide;
  gather(tree, plans, {top.left, left_count}, left_slots, wide);
  gather(tree, plans, {top.right, leaf_count - left_count}, kMaxChildren - left_slots, wide);
  return wide;
}

}  // namespace vernier
