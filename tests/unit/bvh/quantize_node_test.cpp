#include "bvh/quantize_node.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "bvh/box.h"
#include "bvh/decode_record.h"
#include "shared/bvh_record.h"

namespace vernier {
namespace {

// Is a + b * c <= d exactly? long double has 64 bits, too few for sums of very different size, so compare by parts: the
// rounded difference has the sign of the exact one.
bool sum_at_most(double origin, double offset, double limit) {
  const long double rounded = static_cast<long double>(limit) - static_cast<long double>(origin);
  const long double error = (limit - (rounded + origin));
  return offset < rounded || (offset == rounded && error >= 0.0L);
}

void expect_holds(const BvhRecord& record, std::span<const Box> children) {
  const DecodedNode node = decode_node(record);
  ASSERT_EQ(node.child_count, children.size());
  for (int axis = 0; axis < 3; ++axis) {
    const double origin = std::bit_cast<float>(record[axis]);
    for (std::size_t i = 0; i < children.size(); ++i) {
      const double lo = ((record[4 + 2 * axis] >> (8 * i)) & 255u) * node.cell[axis];
      const double hi = ((record[5 + 2 * axis] >> (8 * i)) & 255u) * node.cell[axis];
      EXPECT_TRUE(sum_at_most(origin, lo, children[i].lo[axis])) << axis << " " << i;
      EXPECT_TRUE(hi == static_cast<double>(children[i].hi[axis]) - origin ||
                  !sum_at_most(origin, hi, children[i].hi[axis]))
          << axis << " " << i;
      EXPECT_GT(node.boxes[i].lo[axis] + node.cell[axis], children[i].lo[axis] - 1e-12 * std::abs(origin));
      EXPECT_LT(node.boxes[i].hi[axis] - node.cell[axis], children[i].hi[axis] + 1e-12 * std::abs(origin));
    }
  }
}

TEST(QuantizeNode, GivesWholeCellsAsWorkedByHand) {
  const std::array<Box, 2> children = {Box{{0, 0, 0}, {254, 1, 2.5f}}, Box{{1.5f, 0, 1}, {2.5f, 0.5f, 254.5f}}};
  const BvhRecord record = quantize_node(children, {{0, 0, 0}, {254, 1, 254.5f}}, 99);
  // 254 units in cells 1 to 254: 2^0. 1 unit: 2^-7, because 254 x 2^-8 falls short. 254.5 units: 2^1.
  EXPECT_EQ(record[3], 127u | 120u << 8 | 128u << 16);
  EXPECT_EQ(std::bit_cast<float>(record[0]), -1.0f);
  EXPECT_EQ(std::bit_cast<float>(record[1]), -0x1p-7f);
  EXPECT_EQ(std::bit_cast<float>(record[2]), -2.0f);
  EXPECT_EQ(record[4], 0xffff0201u);
  EXPECT_EQ(record[5], 0x010104ffu);
  EXPECT_EQ(record[6], 0xffff0101u);
  EXPECT_EQ(record[7], 0x01014181u);
  EXPECT_EQ(record[8], 0xffff0101u);
  EXPECT_EQ(record[9], 0x01018103u);
  EXPECT_EQ(record[10], BVH_CHILD_BASE_TAG | 99u);
  EXPECT_EQ(record[11], 2u);
  EXPECT_TRUE(decode_node(record).slot_is_empty[2] && decode_node(record).slot_is_empty[3]);
}

TEST(QuantizeNode, RoundsOutwardsWhereADoubleDifferenceRounds) {
  // From the grid's origin, the coordinates -1e-20 and 1e-20 are whole cells away in double; they must go to either
  // side.
  const std::array<Box, 2> children = {Box{{-1e-20f, -1, -1}, {1, 1, 1}}, Box{{-1, -1, -1}, {1e-20f, 1, 1}}};
  const BvhRecord record = quantize_node(children, {{-1, -1, -1}, {1, 1, 1}}, 1);
  const double cell = decode_node(record).cell.x;
  const double origin = std::bit_cast<float>(record[0]);
  EXPECT_LT(origin + (record[4] & 255u) * cell, -1e-20);
  EXPECT_GT(origin + ((record[5] >> 8) & 255u) * cell, 1e-20);
}

TEST(QuantizeNode, HoldsRandomBoxesOfAllSizes) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> place(-1.0f, 1.0f);
  std::uniform_int_distribution<int> exponent(-140, 98);
  for (int i = 0; i < 20000; ++i) {
    const int largest = exponent(random);
    const auto coordinate = [&] { return std::ldexp(place(random), largest - static_cast<int>(random() % 40)); };
    std::vector<Box> children;
    Box node;
    for (std::uint32_t k = 0; k <= random() % 4; ++k) {
      Box box;
      grow(box, glm::vec3(coordinate(), coordinate(), coordinate()));
      grow(box, glm::vec3(coordinate(), coordinate(), coordinate()));
      grow(node, box);
      children.push_back(pad_box(box, 0.0f));
    }
    const BvhRecord record = quantize_node(children, pad_box(node, 0.0f), 1);
    expect_holds(record, children);
    for (const int word : {4, 5, 6, 7, 8, 9}) {
      for (int byte = 0; byte < 4; ++byte) EXPECT_GE(record[word] >> (8 * byte) & 255u, 1u);
    }
    for (int axis = 0; axis < 3; ++axis) {
      const std::uint32_t byte = (record[3] >> (8 * axis)) & 255u;
      EXPECT_GE(byte, kLeastExponent);
      EXPECT_LE(byte, 254u);
    }
  }
}

TEST(PadBox, KeepsItsPromiseAndNests) {
  std::mt19937 random(6);
  std::uniform_real_distribution<float> place(-1.0f, 1.0f);
  for (int i = 0; i < 20000; ++i) {
    const auto coordinate = [&] { return std::ldexp(place(random), -static_cast<int>(random() % 60)); };
    Box inner;
    grow(inner, glm::vec3(coordinate(), coordinate(), coordinate()));
    grow(inner, glm::vec3(coordinate(), coordinate(), coordinate()));
    Box outer = inner;
    grow(outer, glm::vec3(coordinate(), coordinate(), coordinate()));
    const Box padded = pad_box(inner, 2.0f);
    const Box padded_outer = pad_box(outer, 2.0f);
    const double padding = promised_padding(inner, 2.0f);
    EXPECT_GE(padding, 0x1p-39);
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_LE(padded.lo[axis], inner.lo[axis] - padding);
      EXPECT_GE(padded.hi[axis], inner.hi[axis] + padding);
      EXPECT_LE(padded_outer.lo[axis], padded.lo[axis]);
      EXPECT_GE(padded_outer.hi[axis], padded.hi[axis]);
    }
  }
}

TEST(Grow, ByAnEmptyBoxChangesNothing) {
  Box box{{1, 2, 3}, {4, 5, 6}};
  grow(box, Box());
  EXPECT_EQ(box.lo, glm::vec3(1, 2, 3));
  EXPECT_EQ(box.hi, glm::vec3(4, 5, 6));
  EXPECT_EQ(half_area(Box()), 0.0);
}

}  // namespace
}  // namespace vernier
