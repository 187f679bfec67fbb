#include "scene/polygon_triangles.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

namespace vernier {
namespace {

double area_along_z(const std::vector<glm::dvec3>& p, const PolygonTriangle& t) {
  const glm::dvec3 a = p[t[1]] - p[t[0]];
  const glm::dvec3 b = p[t[2]] - p[t[0]];
  return 0.5 * (a.x * b.y - a.y * b.x);
}

// A cut is right when no triangle is turned over and the areas add up.
void expect_exact_cover(const std::vector<glm::dvec3>& polygon, double area) {
  std::vector<PolygonTriangle> triangles;
  append_polygon_triangles(polygon, triangles);
  ASSERT_EQ(triangles.size(), polygon.size() - 2);
  double sum = 0.0;
  for (const PolygonTriangle& t : triangles) {
    EXPECT_GE(area_along_z(polygon, t), 0.0);
    sum += area_along_z(polygon, t);
  }
  EXPECT_NEAR(sum, area, 1e-9 * area);
}

TEST(PolygonTriangles, ConvexQuadIsCutAlongTheShorterDiagonal) {
  std::vector<PolygonTriangle> triangles;
  append_polygon_triangles(std::vector<glm::dvec3>{{0, 0, 0}, {4, 0, 0}, {5, 1, 0}, {1, 1, 0}}, triangles);
  EXPECT_EQ(triangles, (std::vector<PolygonTriangle>{{0, 1, 3}, {1, 2, 3}}));
}

TEST(PolygonTriangles, DartIsCutAtItsReflexCornerWhereverItStarts) {
  // The shorter diagonal, between the two wing tips, lies outside.
  const std::vector<glm::dvec3> dart = {{0, 0, 0}, {1, -0.2, 0}, {0.9, 0, 0}, {1, 0.2, 0}};
  for (std::size_t start = 0; start < 4; ++start) {
    std::vector<glm::dvec3> turned;
    for (std::size_t i = 0; i < 4; ++i) turned.push_back(dart[(start + i) % 4]);
    expect_exact_cover(turned, 0.18);
  }
}

TEST(PolygonTriangles, OutlinesThatTouchThemselvesCoverNoMore) {
  // Two squares that share a corner, and three in a row, from every corner on.
  const std::vector<glm::dvec3> two = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {2, 1, 0},
                                       {2, 2, 0}, {1, 2, 0}, {1, 1, 0}, {0, 1, 0}};
  const std::vector<glm::dvec3> three = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {2, 1, 0}, {2, 2, 0}, {3, 2, 0},
                                         {3, 3, 0}, {2, 3, 0}, {2, 2, 0}, {1, 2, 0}, {1, 1, 0}, {0, 1, 0}};
  for (const auto& outline : {two, three}) {
    for (std::size_t start = 0; start < outline.size(); ++start) {
      std::vector<glm::dvec3> turned;
      for (std::size_t i = 0; i < outline.size(); ++i) turned.push_back(outline[(start + i) % outline.size()]);
      expect_exact_cover(turned, outline.size() == 8 ? 2.0 : 3.0);
    }
  }
}

TEST(PolygonTriangles, SpikesOutAndBackHaveNoArea) {
  const std::vector<glm::dvec3> outwards = {{0, 0, 0},   {1, 0, 0}, {1, 0.5, 0}, {3, 0.5, 0},
                                            {1, 0.5, 0}, {1, 1, 0}, {0, 1, 0}};
  const std::vector<glm::dvec3> inwards = {{0, 0, 0},   {1, 0, 0}, {1, 0.5, 0}, {0.5, 0.5, 0},
                                           {1, 0.5, 0}, {1, 1, 0}, {0, 1, 0}};
  for (const auto& outline : {outwards, inwards}) {
    for (std::size_t start = 0; start < outline.size(); ++start) {
      std::vector<glm::dvec3> turned;
      for (std::size_t i = 0; i < outline.size(); ++i) turned.push_back(outline[(start + i) % outline.size()]);
      expect_exact_cover(turned, 1.0);
    }
  }
}

TEST(PolygonTriangles, ConcavePolygonsFarFromTheOrigin) {
  std::vector<glm::dvec3> comb;
  for (int tooth = 0; tooth < 5; ++tooth) {
    comb.emplace_back(5e5 + 2 * tooth, 4e6, 7);
    comb.emplace_back(5e5 + 2 * tooth + 1, 4e6, 7);
    comb.emplace_back(5e5 + 2 * tooth + 1, 4e6 + 3, 7);
    comb.emplace_back(5e5 + 2 * tooth + 2, 4e6 + 3, 7);
  }
  comb.emplace_back(5e5 + 10, 4e6 + 4, 7);
  comb.emplace_back(5e5, 4e6 + 4, 7);
  // A bar of 10 x 1 with five teeth of 1 x 3.
  expect_exact_cover(comb, 25.0);
}

TEST(PolygonTriangles, StarOfManyCorners) {
  std::vector<glm::dvec3> star;
  const int count = 1000;
  for (int i = 0; i < count; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / count;
    const double radius = i % 2 == 0 ? 2.0 : 1.0;
    star.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.0);
  }
  expect_exact_cover(star, 0.5 * count * 2.0 * std::sin(2.0 * std::numbers::pi / count));
}

TEST(PolygonTriangles, HoleJoinedByABridge) {
  // A square of 4 x 4 with a hole of 2 x 2, corners 0 and 5 met twice.
  const std::vector<glm::dvec3> ring = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {0, 0, 0},
                                        {1, 1, 0}, {1, 3, 0}, {3, 3, 0}, {3, 1, 0}, {1, 1, 0}};
  expect_exact_cover(ring, 12.0);
}

TEST(PolygonTriangles, StraightCornersLoseNoArea) {
  expect_exact_cover({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 1, 0}, {0, 2, 0}}, 3.0);
}

TEST(PolygonTriangles, WindingIsKeptInEveryPlane) {
  // An arrow in the plane x = 0, clockwise seen from +X: its normals point to -X.
  const std::vector<glm::dvec3> arrow = {{0, 0, 0}, {0, 1, 3}, {0, 2, 0}, {0, 1, 1}, {0, 0.5, 0.5}};
  std::vector<PolygonTriangle> triangles;
  append_polygon_triangles(arrow, triangles);
  ASSERT_EQ(triangles.size(), 3u);
  for (const PolygonTriangle& t : triangles) {
    EXPECT_LE(glm::cross(arrow[t[1]] - arrow[t[0]], arrow[t[2]] - arrow[t[0]]).x, 0.0);
  }
}

TEST(PolygonTriangles, SenselessPolygonsEnd) {
  const double nan = std::nan("");
  for (const auto& polygon :
       std::vector<std::vector<glm::dvec3>>{std::vector<glm::dvec3>(7, glm::dvec3(1.0)),
                                            {{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}, {2, 2, 0}},
                                            {{nan, 0, 0}, {1, nan, 0}, {1, 0, 0}, {0, 1, 0}, {2, 2, 0}}}) {
    std::vector<PolygonTriangle> triangles;
    append_polygon_triangles(polygon, triangles);
    EXPECT_EQ(triangles.size(), polygon.size() - 2);
  }
  // Once a square of the corners' number.
  std::vector<glm::dvec3> long_one;
  for (int i = 0; i < 100000; ++i) long_one.emplace_back(i % 317, i * 7919 % 1009, i == 5 ? nan : 0.0);
  std::vector<PolygonTriangle> many;
  append_polygon_triangles(long_one, many);
  EXPECT_EQ(many.size(), long_one.size() - 2);
  std::vector<PolygonTriangle> none;
  append_polygon_triangles(std::vector<glm::dvec3>(2), none);
  EXPECT_TRUE(none.empty());
}

}  // namespace
}  // namespace vernier
