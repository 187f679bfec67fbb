#include "bvh/instance_tree.h"

#include <gtest/gtest.h>

#include <numeric>

#include "bvh/box.h"
#include "bvh/check_bvh.h"
#include "bvh/decode_record.h"
#include "error.h"
#include "shared/bvh_record.h"
#include "triangle_sets.h"

namespace vernier {
namespace {

using test::Triangles;

bool is_instance(const BvhRecord& record) {
  return (record[3] & (BVH_TRIANGLE | BVH_INSTANCE)) == BVH_INSTANCE;
}

/// Two objects at several places around some triangles.
struct Joined {
  std::vector<Triangles> sets = {test::random_soup(300, 0.1f, 4), test::spheres_on_ground(3)};
  Triangles own = test::random_soup(100, 0.2f, 5);
  std::vector<std::uint32_t> numbers = std::vector<std::uint32_t>(100);
  std::vector<TreeInstance> instances;
  std::vector<Bvh> trees;
  Bvh bvh;

  Joined() {
    std::iota(numbers.begin(), numbers.end(), 1000u);
    std::vector<ObjectTree> objects;
    std::uint32_t place = 100;
    for (const Triangles& set : sets) {
      trees.push_back(build_bvh(set, {}, 1));
      objects.push_back({trees.back(), place});
      place += static_cast<std::uint32_t>(set.size());
    }
    for (std::uint32_t i = 0; i < 9; ++i) {
      const glm::vec3 lo(static_cast<float>(i), 0.5f * static_cast<float>(i % 3), -1.0f);
      instances.push_back({{lo, lo + 1.0f}, i % 2, i + 1});
    }
    bvh = build_instance_tree(
        own, numbers, instances, objects, [](std::uint32_t id) { return id == 7; }, 1);
  }
};

/// The subtree at `root` as a tree of its own, places and numbers as they were; `first_place` is that of its triangles.
Bvh taken_out(const Bvh& bvh, std::uint32_t root, const Bvh& shape, std::uint32_t first_place) {
  Bvh tree = shape;
  for (std::uint32_t i = 0; i < tree.records.size(); ++i) {
    BvhRecord& record = tree.records[i];
    record = bvh.records[root + i];
    if (is_triangle(record)) {
      EXPECT_EQ(record[7], first_place + record[11]);
      record[7] = 0;
    } else {
      record[10] -= root;
    }
  }
  return tree;
}

/// The tree above the objects, stand-ins and ids as they were before.
Bvh upper_tree(const Joined& joined, std::size_t record_count) {
  Bvh tree = joined.bvh;
  tree.records.resize(record_count);
  tree.node_count = tree.triangle_count = 0;
  for (BvhRecord& record : tree.records) {
    if (is_instance(record)) {
      const std::uint32_t number = record[7] >> BVH_INSTANCE_SHIFT;
      const Box& box = joined.instances[number - 1].box;
      const BvhTriangle stand_in{box.lo, box.hi, {box.hi.x, box.lo.y, box.lo.z}, 100 + number - 1};
      record = build_bvh(std::span(&stand_in, 1), {}, 1).records[1];
    } else if (is_triangle(record)) {
      EXPECT_EQ(record[11], 1000 + record[7]);
      EXPECT_EQ((record[3] & BVH_TRIANGLE_NOT_OPAQUE) != 0, record[7] == 7);
      record[11] = record[7];
      record[7] = 0;
    }
    ++(is_triangle(record) ? tree.triangle_count : tree.node_count);
  }
  return tree;
}

TEST(InstanceTree, both_levels_are_sound) {
  const Joined joined;
  std::uint32_t lower = 0;
  for (const Bvh& tree : joined.trees) lower += static_cast<std::uint32_t>(tree.records.size());
  const std::uint32_t upper = static_cast<std::uint32_t>(joined.bvh.records.size()) - lower;
  const std::uint32_t roots[] = {upper, upper + static_cast<std::uint32_t>(joined.trees[0].records.size())};
  for (std::size_t i = 0; i < 2; ++i) {
    const Bvh tree = taken_out(joined.bvh, roots[i], joined.trees[i], i == 0 ? 100 : 400);
    EXPECT_EQ(check_bvh(tree, joined.sets[i]), "") << i;
  }
  Triangles all = joined.own;
  for (const TreeInstance& one : joined.instances) {
    all.push_back({one.box.lo, one.box.hi, {one.box.hi.x, one.box.lo.y, one.box.lo.z}, 99 + one.number});
  }
  Bvh tree = upper_tree(joined, upper);
  const Bvh alone = build_bvh(all, {}, 1);
  tree.depth = alone.depth;
  tree.sah_cost = alone.sah_cost;
  EXPECT_EQ(check_bvh(tree, all), "");
  EXPECT_EQ(joined.bvh.depth, alone.depth + 1 + std::max(joined.trees[0].depth, joined.trees[1].depth));
  EXPECT_GT(joined.bvh.sah_cost, alone.sah_cost);
}

TEST(InstanceTree, an_instance_is_a_node_with_one_child) {
  const Joined joined;
  std::uint32_t count = 0;
  const float extent = longest_side(joined.bvh.bounds);
  for (const BvhRecord& record : joined.bvh.records) {
    if (!is_instance(record)) continue;
    ++count;
    const DecodedNode node = decode_node(record);
    const TreeInstance& instance = joined.instances[(record[7] >> BVH_INSTANCE_SHIFT) - 1];
    EXPECT_EQ(node.child_count, 1u);
    EXPECT_FALSE(is_triangle(joined.bvh.records[node.child_base]));
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_LE(node.boxes[0].lo[axis], instance.box.lo[axis] - promised_padding(instance.box, extent));
      EXPECT_GE(node.boxes[0].hi[axis], instance.box.hi[axis] + promised_padding(instance.box, extent));
    }
  }
  EXPECT_EQ(count, 9u);
  EXPECT_EQ(joined.bvh.instance_count, 9u);
}

TEST(InstanceTree, what_has_no_triangles_is_left_out) {
  std::vector<ObjectTree> objects(2);
  objects[1].bvh = build_bvh(test::flat_grid(3), {}, 1);
  const std::vector<TreeInstance> instances = {{{glm::vec3(0), glm::vec3(1)}, 0, 1}};
  const Bvh bvh = build_instance_tree({}, {}, instances, objects, {}, 1);
  EXPECT_TRUE(bvh.records.empty());
  EXPECT_EQ(bvh.depth, 0u);
}

TEST(InstanceTree, upper_boxes_hold_all_triangles) {
  for (const test::NamedSet& set : test::all_sets()) {
    const Bvh bvh = build_bvh(set.triangles, {}, 1);
    Box all;
    for (const Box& box : upper_boxes(bvh)) grow(all, box);
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_LE(all.lo[axis], bvh.bounds.lo[axis]) << set.name;
      EXPECT_GE(all.hi[axis], bvh.bounds.hi[axis]) << set.name;
    }
    EXPECT_LE(upper_boxes(bvh).size(), 16u);
  }
  EXPECT_TRUE(upper_boxes({}).empty());
}

}  // namespace
}  // namespace vernier
