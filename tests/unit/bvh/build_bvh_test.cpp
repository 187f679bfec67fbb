#include "bvh/build_bvh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <chrono>
#include <cmath>
#include <stdexcept>
#include <thread>

#include "bvh/check_bvh.h"
#include "bvh/decode_record.h"
#include "shared/bvh_record.h"
#include "triangle_sets.h"

namespace vernier::test {
namespace {

TEST(BuildBvh, PassesTheCheckOnEverySet) {
  for (const auto& [name, triangles] : all_sets()) {
    for (const BuildMethod method : kBuildMethods) {
      EXPECT_EQ(check_bvh(build_bvh(triangles, {}, 2, method), triangles), "") << name << " " << to_string(method);
    }
  }
}

TEST(BuildBvh, OfNothingIsEmpty) {
  const Bvh bvh = build_bvh({}, {}, 2);
  EXPECT_TRUE(bvh.records.empty());
  EXPECT_EQ(bvh.depth, 0u);
  EXPECT_EQ(bvh.sah_cost, 0.0);
  EXPECT_EQ(check_bvh(bvh, {}), "");
}

TEST(BuildBvh, OfTrianglesWithoutAreaIsEmpty) {
  Triangles triangles;
  add(triangles, {1, 2, 3}, {1, 2, 3}, {1, 2, 3});
  add(triangles, {0, 0, 0}, {1, 1, 1}, {3, 3, 3});
  const Bvh bvh = build_bvh(triangles, {}, 2);
  EXPECT_TRUE(bvh.records.empty());
  EXPECT_EQ(check_bvh(bvh, triangles), "");
}

TEST(BuildBvh, OfOneTriangleIsARootWithOneChild) {
  Triangles triangles = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 77}};
  const Bvh bvh = build_bvh(triangles, {}, 1);
  ASSERT_EQ(bvh.records.size(), 2u);
  ASSERT_FALSE(is_triangle(bvh.records[0]));
  EXPECT_EQ(decode_node(bvh.records[0]).child_count, 1u);
  EXPECT_EQ(decode_node(bvh.records[0]).child_base, 1u);
  ASSERT_TRUE(is_triangle(bvh.records[1]));
  EXPECT_EQ(decode_triangle(bvh.records[1]).id, 77u);
  EXPECT_EQ(bvh.depth, 1u);
  EXPECT_EQ(bvh.node_count, 1u);
}

TEST(BuildBvh, LeavesOutTrianglesWithoutAreaAmongOthers) {
  Triangles triangles = random_soup(40000, 0.01f, 11);
  for (std::size_t i = 0; i < triangles.size(); i += 3) {
    triangles[i].v2 = triangles[i].v1;
  }
  const Bvh bvh = build_bvh(triangles, {}, 2);
  EXPECT_EQ(bvh.triangle_count, 40000u - 13334u);
  EXPECT_EQ(check_bvh(bvh, triangles), "");
}

TEST(BuildBvh, IsBitIdenticalForEveryThreadCount) {
  // Large enough for the threaded bins, and with areas left out.
  for (const Triangles& triangles : {spheres_on_ground(40), random_soup(70000, 0.02f, 12), identical(70000)}) {
    for (const BuildMethod method : kBuildMethods) {
      const Bvh one = build_bvh(triangles, {}, 1, method);
      for (const unsigned thread_count : {0u, 2u, 5u}) {
        const Bvh other = build_bvh(triangles, {}, thread_count, method);
        EXPECT_TRUE(one.records == other.records) << thread_count << " " << to_string(method);
        EXPECT_EQ(one.depth, other.depth);
        EXPECT_EQ(one.sah_cost, other.sah_cost);
      }
    }
  }
}

TEST(BuildBvh, KeepsTheDepthPromise) {
  for (const auto& [name, triangles] : all_sets()) {
    const double most = 48.0 + std::ceil(std::log2(static_cast<double>(triangles.size())));
    for (const BuildMethod method : kBuildMethods) {
      EXPECT_LE(build_bvh(triangles, {}, 2, method).depth, std::max(most, 1.0)) << name;
    }
  }
}

TEST(BuildBvh, HalvesIdenticalTriangles) {
  constexpr std::uint32_t kCount = 100000;
  const Triangles triangles = identical(kCount);
  for (const BuildMethod method : kBuildMethods) {
    const Bvh bvh = build_bvh(triangles, {}, 2, method);
    EXPECT_EQ(check_bvh(bvh, triangles), "");
    // ceil(log2 100000) = 17 binary levels, and a wide tree is never deeper.
    EXPECT_LE(bvh.depth, 17u);
  }
}

TEST(BuildBvh, MarksTrianglesThatMayLetLightPass) {
  const Triangles triangles = random_soup(100, 0.1f, 13);
  const Bvh bvh = build_bvh(
      triangles, [](std::uint32_t id) { return id % 3 == 0; }, 2);
  for (const BvhRecord& record : bvh.records) {
    if (is_triangle(record)) {
      EXPECT_EQ((record[3] & BVH_TRIANGLE_NOT_OPAQUE) != 0, record[11] % 3 == 0);
    }
  }
}

TEST(BuildBvh, PassesOnWhatTheCallbackThrows) {
  const Triangles triangles = random_soup(30000, 0.1f, 14);
  const auto fail = [](std::uint32_t) -> bool { throw std::runtime_error("no such material"); };
  EXPECT_THROW(build_bvh(triangles, fail, 3), std::runtime_error);
}

// The others wait for tasks of the thread that failed, and finish theirs after it: whether it fails alone or all do.
TEST(BuildBvh, EndsWhereProgressThrows) {
  const Triangles triangles = random_soup(20000, 0.1f, 14);
  for (const bool once : {false, true}) {
    for (int calls = 1; calls < 4; ++calls) {
      std::atomic<int> call = 0;
      const auto fail = [&](double) {
        const int number = ++call;
        if (number < calls || (once && number > calls)) return;
        if (!once) std::this_thread::sleep_for(std::chrono::milliseconds(20));
        throw std::runtime_error("interrupted");
      };
      EXPECT_THROW(build_bvh(triangles, {}, 8, BuildMethod::standard, fail), std::runtime_error) << calls << once;
    }
  }
}

TEST(BuildBvh, KeepsChildrenNearTheirParents) {
  const Bvh bvh = build_bvh(random_soup(5000, 0.05f, 15), {}, 2);
  // Depth first: what is below the first inner child of a node begins right behind the node's children.
  for (const BvhRecord& record : bvh.records) {
    if (is_triangle(record)) {
      continue;
    }
    const DecodedNode node = decode_node(record);
    for (std::uint32_t i = 0; i < node.child_count; ++i) {
      const BvhRecord& child = bvh.records[node.child_base + i];
      if (!is_triangle(child)) {
        EXPECT_EQ(decode_node(child).child_base, node.child_base + node.child_count);
        break;
      }
    }
  }
}

}  // namespace
}  // namespace vernier::test
