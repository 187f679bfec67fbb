#include "bvh/collapse.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "bvh/box.h"
#include "triangle_sets.h"

namespace vernier::test {
namespace {

// Area of the wide nodes below `node` when children are opened greedily, the largest first.
double greedy_area(const BinaryTree& tree, std::uint32_t node) {
  std::vector<BinaryChild> children = {tree.nodes[node].left, tree.nodes[node].right};
  while (children.size() < kMaxChildren) {
    double largest = -1.0;
    std::size_t chosen = 0;
    for (std::size_t i = 0; i < children.size(); ++i) {
      if (!is_leaf(children[i]) && half_area(tree.nodes[children[i]].box) > largest) {
        largest = half_area(tree.nodes[children[i]].box);
        chosen = i;
      }
    }
    if (largest < 0.0) {
      break;
    }
    const BinaryNode opened = tree.nodes[children[chosen]];
    children[chosen] = opened.left;
    children.push_back(opened.right);
  }
  double area = half_area(tree.nodes[node].box);
  for (const BinaryChild child : children) {
    area += is_leaf(child) ? 0.0 : greedy_area(tree, child);
  }
  return area;
}

// Least area of wide nodes below a binary node as at most 1, 2 and 3 children, in doubles.
using LeastAreas = std::array<double, kMaxChildren - 1>;

// The numbers of nodes rise from parents to what is below them.
double least_area(const BinaryTree& tree) {
  std::vector<LeastAreas> areas(tree.nodes.size());
  const auto area_of = [&](BinaryChild child, std::uint32_t slots) {
    return is_leaf(child) ? 0.0 : areas[child][slots - 1];
  };
  for (std::uint32_t i = static_cast<std::uint32_t>(areas.size()); i-- > 0;) {
    const BinaryNode& node = tree.nodes[i];
    const auto divided = [&](std::uint32_t slots) {
      double least = area_of(node.left, 1) + area_of(node.right, slots - 1);
      for (std::uint32_t left = 2; left < slots; ++left) {
        least = std::min(least, area_of(node.left, left) + area_of(node.right, slots - left));
      }
      return least;
    };
    areas[i][0] = half_area(node.box) + divided(kMaxChildren);
    for (std::uint32_t slots = 2; slots < kMaxChildren; ++slots) {
      areas[i][slots - 1] = std::min(areas[i][slots - 2], divided(slots));
    }
  }
  return areas[0][0];
}

struct Total {
  double area = 0.0;
  std::uint32_t records = 1;
  std::uint32_t leaves = 0;
};

// Follows the plans from `node` down.
void add_planned(const BinaryTree& tree, const CollapsePlans& plans, std::uint32_t node, std::uint32_t leaf_count,
                 Total& total) {
  total.area += half_area(tree.nodes[node].box);
  const WideChildren wide = wide_children(tree, plans, node, leaf_count);
  std::uint32_t below = 0;
  for (std::uint32_t i = 0; i < wide.count; ++i) {
    const auto [child, count] = wide.children[i];
    ++total.records;
    below += count;
    if (is_leaf(child)) {
      ++total.leaves;
    } else {
      add_planned(tree, plans, child, count, total);
    }
  }
  EXPECT_EQ(below, leaf_count);
}

TEST(PlanCollapse, FindsTheLeastAreaAndCountsRight) {
  ThreadTeam team(2);
  for (const auto& [name, triangles] : all_sets()) {
    LargeArray<std::byte> memory(kWorkspaceBytes * triangles.size());
    const BinaryTree tree = build_binary_tree(triangles, BuildMethod::standard, team, Workspace(memory));
    if (tree.leaf_count < 2) {
      continue;
    }
    const CollapsePlans plans = plan_collapse(tree, team);
    Total total;
    add_planned(tree, plans, 0, tree.leaf_count, total);
    EXPECT_EQ(total.leaves, tree.leaf_count) << name;
    EXPECT_EQ(total.records, record_count(plans, tree.root)) << name;
    // Plans add floats: 2^-24 for each of some thousand additions.
    EXPECT_NEAR(total.area, least_area(tree), 1e-4 * total.area) << name;
    EXPECT_LE(total.area, greedy_area(tree, 0) * (1.0 + 1e-4)) << name;
  }
}

}  // namespace
}  // namespace vernier::test
