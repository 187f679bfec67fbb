#include "bvh/bvh_statistics.h"

#include <gtest/gtest.h>

#include "bvh/build_bvh.h"
#include "triangle_sets.h"

namespace vernier::test {
namespace {

TEST(BvhStatistics, OfAnEmptyTreeAreZero) {
  const BvhStatistics statistics = bvh_statistics(Bvh());
  EXPECT_EQ(statistics.node_count, 0u);
  EXPECT_EQ(statistics.bytes, 0u);
  EXPECT_EQ(statistics.mean_child_count, 0.0);
}

TEST(BvhStatistics, CountWhatTheTreeHolds) {
  const Bvh bvh = build_bvh(random_soup(5000, 0.02f, 1), {}, 2);
  const BvhStatistics statistics = bvh_statistics(bvh);
  EXPECT_EQ(statistics.triangle_count, 5000u);
  EXPECT_EQ(statistics.node_count, bvh.node_count);
  EXPECT_EQ(statistics.bytes, 48u * bvh.records.size());
  EXPECT_EQ(statistics.depth, bvh.depth);
  EXPECT_EQ(statistics.sah_cost, bvh.sah_cost);
  // Every record but the root is the child of one node.
  EXPECT_DOUBLE_EQ(statistics.mean_child_count, (bvh.records.size() - 1.0) / bvh.node_count);
  EXPECT_GT(statistics.mean_child_count, 3.0);
}

TEST(BvhStatistics, WideCostOfOneTriangleIsRootAndTriangle) {
  Triangles triangles;
  add(triangles, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  // Quantisation widens the box by up to a cell, 1/127 of the side, at each end.
  EXPECT_NEAR(bvh_statistics(build_bvh(triangles, {}, 1)).wide_cost, 2.0, 0.05);
}

}  // namespace
}  // namespace vernier::test
