#include "bvh/reinsertion.h"

#include <gtest/gtest.h>

#include "bvh/build_bvh.h"
#include "bvh/check_bvh.h"
#include "triangle_sets.h"

namespace vernier::test {
namespace {

double cost(const Triangles& triangles, BuildMethod method) {
  const Bvh bvh = build_bvh(triangles, {}, 2, method);
  EXPECT_EQ(check_bvh(bvh, triangles), "");
  return bvh.sah_cost;
}

TEST(ReinsertSubtrees, NeverMakesATreeDearer) {
  for (const auto& [name, triangles] : all_sets()) {
    // Moves are judged by floats.
    EXPECT_LE(cost(triangles, BuildMethod::quality), cost(triangles, BuildMethod::standard) * (1.0 + 1e-5)) << name;
  }
}

TEST(ReinsertSubtrees, MakesATreeOfSliversCheaper) {
  const Triangles triangles = slivers(20000, 4);
  EXPECT_LT(cost(triangles, BuildMethod::quality), 0.95 * cost(triangles, BuildMethod::standard));
}

TEST(ReinsertSubtrees, KeepsASubtreeOfTwoAndThreeTriangles) {
  for (const std::size_t count : {2u, 3u, 4u}) {
    Triangles triangles = random_soup(8, 0.1f, 3);
    triangles.resize(count);
    EXPECT_GT(cost(triangles, BuildMethod::quality), 0.0);
  }
}

}  // namespace
}  // namespace vernier::test
