#include "bvh/hidden_triangles.h"

#include <gtest/gtest.h>

namespace vernier {
namespace {

BvhTriangle triangle(float x, std::uint32_t id) {
  return {{x, 0, 0}, {x + 1, 0, 0}, {x, 1, 0}, id};
}

using Ids = std::vector<std::uint32_t>;

Ids kept_ids(std::vector<BvhTriangle> triangles, const std::function<bool(std::uint32_t)>& not_opaque,
             unsigned thread_count = 2) {
  const std::size_t before = triangles.size();
  const std::size_t removed = remove_hidden(triangles, not_opaque, thread_count);
  EXPECT_EQ(removed, before - triangles.size());
  Ids ids;
  for (const BvhTriangle& one : triangles) ids.push_back(one.id);
  return ids;
}

TEST(RemoveHidden, TheFirstOfIdenticalTrianglesStays) {
  const std::vector<BvhTriangle> triangles = {triangle(0, 0), triangle(1, 1), triangle(0, 2), triangle(0, 3)};
  EXPECT_EQ(kept_ids(triangles, nullptr), (Ids{0, 1}));
  EXPECT_EQ(kept_ids({}, nullptr), Ids{});
}

TEST(RemoveHidden, WhatLiesBehindATriangleThatLetsLightPassIsSeen) {
  const std::vector<BvhTriangle> triangles = {triangle(0, 0), triangle(0, 1), triangle(0, 2), triangle(0, 3)};
  // 0 and 1 are panes, 2 is a wall: 3, whatever it is, is hidden.
  EXPECT_EQ(kept_ids(triangles, [](std::uint32_t id) { return id < 2; }), (Ids{0, 1, 2}));
  EXPECT_EQ(kept_ids(triangles, [](std::uint32_t id) { return id != 2; }), (Ids{0, 1, 2}));
}

TEST(RemoveHidden, TrianglesWithoutAreaAreLeftToTheBuild) {
  const BvhTriangle point = {{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, 0};
  EXPECT_EQ(kept_ids({point, point, point}, nullptr), (Ids{0, 0, 0}));
}

TEST(RemoveHidden, OtherCornersOrAnotherOrderStay) {
  const BvhTriangle turned = {{1, 0, 0}, {0, 1, 0}, {0, 0, 0}, 1};  // rounds otherwise
  BvhTriangle near = triangle(0, 2);
  near.v2.y = 0x1.fffffep-1f;
  EXPECT_EQ(kept_ids({triangle(0, 0), turned, near}, nullptr), (Ids{0, 1, 2}));
}

// Many pieces of work, equal triangles in all of them, and every seventh a pane: what stays is told one by one.
TEST(RemoveHidden, IsTheSameForEveryThreadCount) {
  constexpr std::uint32_t kCount = 200000, kKinds = 30000;
  const auto is_pane = [](std::uint32_t id) { return id % 7 == 0; };
  std::vector<BvhTriangle> triangles;
  std::vector<char> has_opaque(kKinds, 0);
  Ids expected;
  for (std::uint32_t id = 0; id < kCount; ++id) {
    const std::uint32_t kind = id * 7919u % kKinds;
    triangles.push_back(triangle(static_cast<float>(kind), id));
    if (!has_opaque[kind]) expected.push_back(id);
    if (!is_pane(id)) has_opaque[kind] = 1;
  }
  for (const unsigned thread_count : {1u, 2u, 5u}) EXPECT_EQ(kept_ids(triangles, is_pane, thread_count), expected);
}

}  // namespace
}  // namespace vernier
