#include "bvh/zero_area.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace vernier {
namespace {

TEST(HasZeroArea, SeesPointsAndLines) {
  EXPECT_TRUE(has_zero_area({1, 2, 3}, {1, 2, 3}, {1, 2, 3}));
  EXPECT_TRUE(has_zero_area({1, 2, 3}, {4, 5, 6}, {1, 2, 3}));
  EXPECT_TRUE(has_zero_area({0, 0, 0}, {1, 2, 3}, {-2, -4, -6}));
  EXPECT_TRUE(has_zero_area({-0.0f, 0, 0}, {0, -0.0f, 0}, {5, 1, 1}));
}

TEST(HasZeroArea, KeepsTrianglesInEveryPlane) {
  EXPECT_FALSE(has_zero_area({0, 0, 0}, {1, 0, 0}, {0, 1, 0}));
  EXPECT_FALSE(has_zero_area({0, 0, 0}, {0, 1, 0}, {0, 0, 1}));
  EXPECT_FALSE(has_zero_area({0, 0, 0}, {1, 0, 0}, {0, 0, 1}));
}

TEST(HasZeroArea, IsExactWhereDoubleDifferencesRound) {
  // The difference of 1 and 2^-80 is 1 in double, but these three do not lie on a line.
  EXPECT_FALSE(has_zero_area({0x1p-80f, 0, 0}, {1, 1, 0}, {2, 2, 0}));
  EXPECT_TRUE(has_zero_area({0, 0, 0}, {1, 1, 0}, {2, 2, 0}));
  // Products of 2^-149 and of 2^126 are in the range of double.
  EXPECT_FALSE(has_zero_area({0, 0, 0}, {0x1p-149f, 0, 0}, {0, 0x1p-149f, 0}));
  EXPECT_TRUE(has_zero_area({0x1p-149f, 0x1p-149f, 0}, {0, 0, 0}, {0x1p126f, 0x1p126f, 0}));
  EXPECT_FALSE(has_zero_area({0x1p-149f, 0, 0}, {0, 0, 0}, {0x1p126f, 0x1p126f, 0}));
}

TEST(HasZeroArea, TellsOneUlpOffTheLine) {
  std::mt19937 random(3);
  std::uniform_int_distribution<int> whole(-1000, 1000);
  for (int i = 0; i < 10000; ++i) {
    const auto vector = [&] { return glm::vec3(whole(random), whole(random), whole(random)); };
    const glm::vec3 a = vector();
    const glm::vec3 step = vector();
    if (step.x == 0.0f || step.y == 0.0f || a.y + 3.0f * step.y == 0.0f) {
      continue;
    }
    // Small whole numbers: all of these are exact, so the corners lie on a line.
    const glm::vec3 b = a + step;
    glm::vec3 c = a + 3.0f * step;
    ASSERT_TRUE(has_zero_area(a, b, c)) << i;
    c.y = std::nextafter(c.y, INFINITY);
    ASSERT_FALSE(has_zero_area(a, b, c)) << i;
  }
}

TEST(HasZeroArea, DoesNotDependOnTheOrderOfCorners) {
  std::mt19937 random(4);
  std::uniform_real_distribution<float> place(-1.0f, 1.0f);
  for (int i = 0; i < 10000; ++i) {
    const glm::vec3 a(place(random), place(random), place(random));
    const glm::vec3 b(place(random), place(random), place(random));
    // Rounded, so on the line or an ulp beside it.
    const glm::vec3 c = 0.5f * (a + b);
    const bool zero = has_zero_area(a, b, c);
    EXPECT_EQ(zero, has_zero_area(b, c, a));
    EXPECT_EQ(zero, has_zero_area(c, b, a));
  }
}

}  // namespace
}  // namespace vernier
