#include "bvh/morton_code.h"

#include <gtest/gtest.h>

namespace vernier {
namespace {

LaneBox box_to(float x, float y, float z) {
  return {Lanes{0, 0, 0, 0}, Lanes{x, y, z, 0}};
}

TEST(MortonGrid, InterleavesTheBitsOfACell) {
  // A cell is a whole unit, a hair more than 1 wide: centres lie in the middle of theirs.
  const MortonGrid grid(box_to(0x1p21f, 0x1p21f, 0x1p21f));
  EXPECT_EQ(grid.code(Lanes{0.5f, 0.5f, 0.5f, 0}), 0u);
  EXPECT_EQ(grid.code(Lanes{1.5f, 0.5f, 0.5f, 0}), 4u);
  EXPECT_EQ(grid.code(Lanes{0.5f, 1.5f, 0.5f, 0}), 2u);
  EXPECT_EQ(grid.code(Lanes{0.5f, 0.5f, 1.5f, 0}), 1u);
  // x 101, y 011, z 110, a bit of each in turn.
  EXPECT_EQ(grid.code(Lanes{5.5f, 3.5f, 6.5f, 0}), 0b101'011'110u);
}

TEST(MortonGrid, TheFarCornerHasAllBits) {
  const MortonGrid grid(box_to(3.0f, 3.0f, 3.0f));
  EXPECT_EQ(grid.code(Lanes{3.0f, 3.0f, 3.0f, 0}), (std::uint64_t{1} << 63) - 1);
}

TEST(MortonGrid, CellsAreCubes) {
  const MortonGrid grid(box_to(8.0f, 1.0f, 0.0f));
  // An eighth of the longest side is the highest 18 of 21 bits.
  EXPECT_EQ(grid.code(Lanes{0.0f, 1.0f, 0.0f, 0}) >> 54, 0u);
  EXPECT_NE(grid.code(Lanes{0.0f, 1.0f, 0.0f, 0}) >> 51, 0u);
}

TEST(MortonGrid, APointIsOneCell) {
  const LaneBox point{Lanes{1, 2, 3, 0}, Lanes{1, 2, 3, 0}};
  EXPECT_EQ(MortonGrid(point).code(point.lo), 0u);
}

TEST(MortonGrid, HugeAndTinyScenesHaveTheSameCodes) {
  const Lanes centre = {0.3f, 0.8f, 0.6f, 0};
  const std::uint64_t code = MortonGrid(box_to(1, 1, 1)).code(centre);
  EXPECT_EQ(MortonGrid(box_to(0x1p100f, 0x1p100f, 0x1p100f)).code(centre * 0x1p100f), code);
  EXPECT_EQ(MortonGrid(box_to(0x1p-90f, 0x1p-90f, 0x1p-90f)).code(centre * 0x1p-90f), code);
  // Denormal: the far corner is 2^9 steps from the origin, and the steps are told apart.
  const MortonGrid grid(box_to(0x1p-140f, 0x1p-140f, 0x1p-140f));
  EXPECT_LT(grid.code(Lanes{0x1p-149f, 0, 0, 0}), grid.code(Lanes{0x1p-148f, 0, 0, 0}));
}

}  // namespace
}  // namespace vernier
