#include "bvh/corner_order.h"

#include <gtest/gtest.h>

namespace vernier {
namespace {

TEST(CornerOrder, needles_start_between_their_short_edge_and_a_long_one) {
  // 3, 4, 5: the corner between the two shorter edges, wherever it stands.
  const glm::vec3 right(0, 0, 0), far_x(4, 0, 0), far_y(0, 3, 0);
  EXPECT_EQ(corner_opposite_longest_edge(right, far_x, far_y), 0);
  EXPECT_EQ(corner_opposite_longest_edge(far_y, right, far_x), 1);
  EXPECT_EQ(corner_opposite_longest_edge(far_x, far_y, right), 2);
}

TEST(CornerOrder, the_lowest_of_equals) {
  EXPECT_EQ(corner_opposite_longest_edge({1, 0, 0}, {0, 1, 0}, {0, 0, 1}), 0);
  // Edges 1-2 and 2-0 are equally long, 0-1 is shorter.
  EXPECT_EQ(corner_opposite_longest_edge({0, 0, 0}, {0, 1, 0}, {8, 0.5f, 0}), 0);
  EXPECT_EQ(corner_opposite_longest_edge({2, 2, 2}, {2, 2, 2}, {2, 2, 2}), 0);
}

TEST(CornerOrder, lengths_do_not_overflow_or_vanish) {
  // Squares of these edges are beyond float's range.
  EXPECT_EQ(corner_opposite_longest_edge({0, 0, 0}, {3e30f, 0, 0}, {0, 1e30f, 0}), 0);
  EXPECT_EQ(corner_opposite_longest_edge({0, 0, 3e-30f}, {0, 0, 0}, {0, 1e-30f, 0}), 1);
}

}  // namespace
}  // namespace vernier
