#include "bvh/hidden_triangles.h"

#include <gtest/gtest.h>

namespace vernier {
namespace {

BvhTriangle triangle(float x, std::uint32_t id) {
  return {{x, 0, 0}, {x + 1, 0, 0}, {x, 1, 0}, id};
}

std::vector<std::uint32_t> kept_ids(const std::vector<BvhTriangle>& triangles,
                                    const std::function<bool(std::uint32_t)>& not_opaque) {
  std::vector<std::uint32_t> ids;
  for (const BvhTriangle& one : without_hidden(triangles, not_opaque)) ids.push_back(one.id);
  return ids;
}

using Ids = std::vector<std::uint32_t>;

TEST(WithoutHidden, TheFirstOfIdenticalTrianglesStays) {
  const std::vector<BvhTriangle> triangles = {triangle(0, 0), triangle(1, 1), triangle(0, 2), triangle(0, 3)};
  EXPECT_EQ(kept_ids(triangles, nullptr), (Ids{0, 1}));
  EXPECT_EQ(kept_ids({}, nullptr), Ids{});
}

TEST(WithoutHidden, WhatLiesBehindATriangleThatLetsLightPassIsSeen) {
  const std::vector<BvhTriangle> triangles = {triangle(0, 0), triangle(0, 1), triangle(0, 2), triangle(0, 3)};
  // 0 and 1 are panes, 2 is a wall: 3, whatever it is, is hidden.
  EXPECT_EQ(kept_ids(triangles, [](std::uint32_t id) { return id < 2; }), (Ids{0, 1, 2}));
  EXPECT_EQ(kept_ids(triangles, [](std::uint32_t id) { return id != 2; }), (Ids{0, 1, 2}));
}

TEST(WithoutHidden, TrianglesWithoutAreaAreLeftToTheBuild) {
  const BvhTriangle point = {{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, 0};
  EXPECT_EQ(without_hidden(std::vector{point, point, point}, nullptr).size(), 3u);
}

TEST(WithoutHidden, OtherCornersOrAnotherOrderStay) {
  const BvhTriangle turned = {{1, 0, 0}, {0, 1, 0}, {0, 0, 0}, 1};  // rounds otherwise
  BvhTriangle near = triangle(0, 2);
  near.v2.y = 0x1.fffffep-1f;
  EXPECT_EQ(kept_ids({triangle(0, 0), turned, near}, nullptr), (Ids{0, 1, 2}));
}

}  // namespace
}  // namespace vernier
