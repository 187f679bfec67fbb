#include "reference/sample_positions.h"

#include <gtest/gtest.h>

#include <vector>

namespace vernier::reference {
namespace {

TEST(SamplePosition, OneSampleIsThePixelCentre) {
  EXPECT_EQ(sample_position(17, 4, 0, 1, 99), glm::dvec2(0.5));
}

// The numbers come from a transcription of the README's formulas with unbounded integers.
TEST(SamplePosition, KnownValues) {
  const double unit = 0x1p-24;
  EXPECT_EQ(sample_position(0, 0, 0, 16, 0), glm::dvec2(8783866, 4172010) * unit);
  EXPECT_EQ(sample_position(0, 0, 1, 16, 0), glm::dvec2(8093886, 16545489) * unit);
  EXPECT_EQ(sample_position(5, 7, 3, 16, 0), glm::dvec2(4579625, 4357509) * unit);
  EXPECT_EQ(sample_position(1279, 719, 15, 16, 42), glm::dvec2(5030329, 14500406) * unit);
}

TEST(TentPosition, KnownValues) {
  EXPECT_EQ(tent_position({0.0, 0.5}), glm::dvec2(-0.5, 0.5));
  EXPECT_EQ(tent_position({0.125, 0.875}), glm::dvec2(0.0, 1.0));  // an eighth of the area on either side of the pixel
}

TEST(SamplePosition, DoesNotDependOnTheNumberOfSamples) {
  for (std::uint32_t sample = 0; sample < 8; ++sample)
    EXPECT_EQ(sample_position(3, 2, sample, 8, 7), sample_position(3, 2, sample, 4096, 7));
}

TEST(SamplePosition, PixelsAndSeedsDiffer) {
  const glm::dvec2 here = sample_position(3, 2, 0, 8, 7);
  EXPECT_NE(here, sample_position(2, 3, 0, 8, 7));
  EXPECT_NE(here, sample_position(3, 2, 0, 8, 8));
}

// Of 2^k points every box of 2^-i x 2^-(k-i) holds exactly one: the definition of a (0, k, 2)-net.
void expect_net(std::uint32_t x, std::uint32_t y, std::uint32_t first, int k) {
  const std::uint32_t count = 1u << k;
  for (int i = 0; i <= k; ++i) {
    std::vector<int> boxes(count, 0);
    for (std::uint32_t sample = first; sample < first + count; ++sample) {
      const glm::dvec2 p = sample_position(x, y, sample, 1024, 5);
      const std::uint32_t column = static_cast<std::uint32_t>(p.x * (1u << i));
      const std::uint32_t row = static_cast<std::uint32_t>(p.y * (1u << (k - i)));
      ++boxes[column * (1u << (k - i)) + row];
    }
    EXPECT_EQ(boxes, std::vector<int>(count, 1)) << "prefix 2^" << k << ", columns 2^" << i;
  }
}

TEST(SamplePosition, EveryPrefixOfAPowerOfTwoIsANet) {
  for (const auto& [x, y] : {std::pair{0u, 0u}, std::pair{631u, 17u}})
    for (int k = 1; k <= 8; ++k) expect_net(x, y, 0, k);
}

TEST(SamplePosition, EveryAlignedBlockIsANet) {
  for (std::uint32_t block = 0; block < 4; ++block) expect_net(12, 34, block * 16, 4);
}

}  // namespace
}  // namespace vernier::reference
