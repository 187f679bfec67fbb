#include "bvh/check_bvh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "bvh/binary_tree.h"
#include "bvh/box.h"
#include "bvh/build_bvh.h"
#include "bvh/collapse.h"
#include "bvh/decode_record.h"
#include "bvh/encode_bvh.h"
#include "triangle_sets.h"

namespace vernier::test {
namespace {

class CheckBvh : public testing::Test {
 protected:
  CheckBvh() : triangles_(random_soup(500, 0.1f, 1)), bvh_(build_bvh(triangles_, {}, 1)) {}

  // The check must name a fault that holds `words` once `change` was made, and none before.
  void expect_fault(const std::string& words, const std::function<void(Bvh&)>& change) const {
    ASSERT_EQ(check_bvh(bvh_, triangles_), "");
    Bvh changed = bvh_;
    change(changed);
    EXPECT_NE(check_bvh(changed, triangles_).find(words), std::string::npos) << check_bvh(changed, triangles_);
  }

  // Number of the n-th triangle record.
  static std::size_t nth_triangle(const Bvh& bvh, int n) {
    std::size_t index = 0;
    while (!is_triangle(bvh.records[index]) || n-- > 0) {
      ++index;
    }
    return index;
  }

  Triangles triangles_;
  Bvh bvh_;
};

TEST_F(CheckBvh, NoticesSwappedTriangles) {
  expect_fault("does not hold", [](Bvh& bvh) {
    // Two that lie far from one another; both have other boxes around them.
    std::swap(bvh.records[nth_triangle(bvh, 0)], bvh.records[nth_triangle(bvh, 400)]);
  });
}

TEST_F(CheckBvh, NoticesAnyBoxSideThatIsTwoCellsShort) {
  for (int axis = 0; axis < 3; ++axis) {
    for (std::uint32_t child = 0; child < 2; ++child) {
      expect_fault("does not hold", [&](Bvh& bvh) { bvh.records[0][5 + 2 * axis] -= 2u << (8 * child); });
      expect_fault("does not hold", [&](Bvh& bvh) { bvh.records[0][4 + 2 * axis] += 2u << (8 * child); });
    }
  }
}

TEST_F(CheckBvh, NoticesABoxThatIsTooLarge) {
  expect_fault("is too large", [](Bvh& bvh) {
    std::uint32_t& hi = bvh.records[0][5];
    hi += (hi & 255u) <= 252u ? 3u : 3u << 8;  // only one of the children can reach the end
  });
}

TEST_F(CheckBvh, NoticesADuplicate) {
  expect_fault("occurs twice", [](Bvh& bvh) { bvh.records[nth_triangle(bvh, 0)] = bvh.records[nth_triangle(bvh, 1)]; });
}

TEST_F(CheckBvh, NoticesADroppedTriangle) {
  Triangles more = triangles_;
  add(more, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  EXPECT_EQ(check_bvh(bvh_, more), "triangle 500 is missing");
  // A node that says it has a child less loses a record.
  expect_fault("empty slot", [](Bvh& bvh) { bvh.records[0][11] -= 1; });
}

TEST_F(CheckBvh, NoticesForeignTriangles) {
  expect_fault("is not in the input", [](Bvh& bvh) { bvh.records[nth_triangle(bvh, 7)][11] = 500; });
  expect_fault("has not the corners", [](Bvh& bvh) { bvh.records[nth_triangle(bvh, 7)][4] ^= 1u; });
  expect_fault("free word", [](Bvh& bvh) { bvh.records[nth_triangle(bvh, 7)][7] = 1; });
}

TEST_F(CheckBvh, NoticesBrokenLinks) {
  expect_fault("beyond the last record", [](Bvh& bvh) { bvh.records[0][10] = 0xffffffffu; });
  expect_fault("has 9 children", [](Bvh& bvh) { bvh.records[0][11] = 9; });
  expect_fault("has two parents", [](Bvh& bvh) { bvh.records[0][10] = BVH_CHILD_BASE_TAG; });
  expect_fault("byte of 0", [](Bvh& bvh) { bvh.records[0][10] &= BVH_CHILD_BASE_MASK; });
  expect_fault("is not reached", [](Bvh& bvh) { bvh.records.push_back(bvh.records.back()); });
  expect_fault("root is a triangle", [](Bvh& bvh) { bvh.records[0] = bvh.records[nth_triangle(bvh, 0)]; });
  expect_fault("is missing", [](Bvh& bvh) { bvh = Bvh(); });
}

TEST_F(CheckBvh, NoticesABrokenGrid) {
  expect_fault("broken grid", [](Bvh& bvh) { bvh.records[0][3] = 0; });
  expect_fault("broken grid", [](Bvh& bvh) { bvh.records[0][3] = 0x00ffffffu; });
  expect_fault("broken grid", [](Bvh& bvh) { bvh.records[0][1] = 0x7fc00000u; });
}

TEST_F(CheckBvh, NoticesWrongTotals) {
  expect_fault("depth", [](Bvh& bvh) { --bvh.depth; });
  expect_fault("node_count", [](Bvh& bvh) { ++bvh.node_count; });
  expect_fault("triangle_count", [](Bvh& bvh) { ++bvh.triangle_count; });
  expect_fault("bounds", [](Bvh& bvh) { bvh.bounds.hi.x += 1e-3f; });
  expect_fault("rays count", [](Bvh& bvh) {
    bvh.coarse = true;
    bvh.bounds.hi.x = 2.0f;
  });
  expect_fault("SAH cost", [](Bvh& bvh) { bvh.sah_cost = 1.0; });
  expect_fault("SAH cost", [](Bvh& bvh) { bvh.sah_cost = 1e6; });
}

// Halves triangles[first, first + count) by their numbers, whatever their places. Returns the subtree's bounds.
Box halve_by_number(const Triangles& triangles, std::uint32_t first, std::uint32_t count, BinaryTree& tree,
                    std::uint32_t node_index) {
  if (count == 1) {
    return triangle_bounds(triangles[first]);
  }
  const std::uint32_t left_count = count / 2;
  BinaryNode& node = tree.nodes[node_index];
  node.left = left_count == 1 ? kLeafBit | first : node_index + 1;
  node.right = count - left_count == 1 ? kLeafBit | (first + left_count) : node_index + left_count;
  node.box = halve_by_number(triangles, first, left_count, tree, node_index + 1);
  grow(node.box, halve_by_number(triangles, first + left_count, count - left_count, tree, node_index + left_count));
  return node.box;
}

// Every box of this tree is sound, only its splits put together what lies far apart.
TEST(CheckBvhLevels, NoticesATreeOfUselessSplits) {
  const Triangles triangles = random_soup(4096, 0.01f, 2);
  const auto count = static_cast<std::uint32_t>(triangles.size());
  const Bvh good = build_bvh(triangles, {}, 1);
  ASSERT_EQ(check_bvh(good, triangles), "");
  BinaryTree tree;
  tree.nodes.resize(count - 1);
  tree.leaf_count = count;
  tree.bounds = halve_by_number(triangles, 0, count, tree, 0);
  // A cost within its bounds: only the levels show what is wrong.
  tree.sah_cost = count;
  ThreadTeam alone(1);
  const Bvh bad = encode_bvh(tree, plan_collapse(tree, alone), triangles, {}, alone);
  const std::string fault = check_bvh(bad, triangles);
  EXPECT_EQ(fault.substr(0, 6), "level ") << fault;
}

}  // namespace
}  // namespace vernier::test
