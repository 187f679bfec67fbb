#include "render/traced_space.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace vernier {
namespace {

double largest_coordinate(const TracedSpace& space, const WorldBounds& bounds) {
  double largest = 0;
  for (const glm::dvec3& corner : {traced_from_world(space, bounds.lo), traced_from_world(space, bounds.hi)}) {
    for (int axis = 0; axis < 3; ++axis) largest = std::max(largest, std::abs(corner[axis]));
  }
  return largest;
}

TEST(TracedSpace, scales_by_a_power_of_two_into_the_unit_cube) {
  for (double size : {1e-12, 0.3, 1.0, 1.0000001, 3.0, 1e6, 1e12}) {
    const WorldBounds bounds{glm::dvec3(-size), glm::dvec3(size / 3)};
    const TracedSpace space = choose_traced_space(bounds);
    int exponent = 0;
    EXPECT_EQ(std::frexp(space.metres_per_unit, &exponent), 0.5) << size;
    EXPECT_GT(largest_coordinate(space, bounds), 0.5) << size;
    EXPECT_LE(largest_coordinate(space, bounds), 1.0) << size;
    EXPECT_EQ(space.center, glm::dvec3(0.0));
  }
}

TEST(TracedSpace, moves_axes_that_do_not_contain_zero) {
  const WorldBounds bounds{{1e6, -2, -7}, {1e6 + 4, 3, -5}};
  const TracedSpace space = choose_traced_space(bounds);
  EXPECT_EQ(space.center, glm::dvec3(1e6 + 2, 0, -6));
  EXPECT_EQ(space.metres_per_unit, 4.0);
  EXPECT_EQ(traced_from_world(space, {1e6 + 4, 3, -7}), glm::dvec3(0.5, 0.75, -0.25));
}

TEST(TracedSpace, of_a_point_or_of_nothing_has_one_metre_per_unit) {
  EXPECT_EQ(choose_traced_space({glm::dvec3(5), glm::dvec3(5)}).metres_per_unit, 1.0);
  const double infinity = std::numeric_limits<double>::infinity();
  const TracedSpace empty = choose_traced_space({glm::dvec3(infinity), glm::dvec3(-infinity)});
  EXPECT_EQ(empty.metres_per_unit, 1.0);
  EXPECT_EQ(empty.center, glm::dvec3(0.0));
}

}  // namespace
}  // namespace vernier
