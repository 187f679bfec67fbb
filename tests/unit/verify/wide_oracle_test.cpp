#include "verify/wide_oracle.h"

#include <gtest/gtest.h>

#include <cmath>

#include "verify/ray_kernel.h"

namespace vernier {
namespace {

const BvhTriangle kTriangle{glm::vec3(0, 0, 2), glm::vec3(4, 0, 2), glm::vec3(0, 4, 2), 0};

TEST(WideCrossing, of_a_ray_through_the_inside) {
  const WideCrossing crossing = wide_crossing(ray_query({1, 1, 0}, {0, 0, 0.5f}), kTriangle);
  EXPECT_TRUE(crossing.inside);
  EXPECT_EQ(crossing.t, 4.0);
  EXPECT_EQ(crossing.nearest_edge, 0.25);
  EXPECT_EQ(crossing.cosine, 1.0);
}

TEST(WideCrossing, counts_edges_as_inside_and_t_backwards_too) {
  EXPECT_TRUE(wide_crossing(ray_query({2, 0, 0}, {0, 0, 1}), kTriangle).inside);
  EXPECT_FALSE(wide_crossing(ray_query({2, -0x1p-100f, 0}, {0, 0, 1}), kTriangle).inside);
  EXPECT_EQ(wide_crossing(ray_query({1, 1, 3}, {0, 0, 1}), kTriangle).t, -1.0);
}

TEST(WideCrossing, sees_corners_between_floats) {
  const long double off = 0x1p-60L;
  const std::array<LongPoint, 3> corners{LongPoint(0, off, 2), LongPoint(4, off, 2), LongPoint(0, 4, 2)};
  EXPECT_FALSE(wide_crossing(ray_query({1, 0, 0}, {0, 0, 1}), corners).inside);
  EXPECT_TRUE(wide_crossing(ray_query({1, 0x1p-59f, 0}, {0, 0, 1}), corners).inside);
}

TEST(WideCrossing, of_a_parallel_ray_there_is_none) {
  const WideCrossing crossing = wide_crossing(ray_query({1, 1, 0}, {1, 0, 0}), kTriangle);
  EXPECT_FALSE(crossing.inside);
  EXPECT_TRUE(std::isnan(crossing.t));
}

TEST(WideNormal, survives_coordinates_whose_products_leave_double) {
  const float tiny = 0x1p-120f;
  const BvhTriangle small{glm::vec3(0), glm::vec3(tiny, 0, 0), glm::vec3(0, tiny, 0), 0};
  EXPECT_EQ(wide_normal(small), glm::dvec3(0, 0, 1));
  EXPECT_EQ(wide_normal(BvhTriangle{glm::vec3(1), glm::vec3(2), glm::vec3(3), 0}), glm::dvec3(0));
}

}  // namespace
}  // namespace vernier
