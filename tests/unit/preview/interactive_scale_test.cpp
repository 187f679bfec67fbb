#include "preview/interactive_scale.h"

#include <gtest/gtest.h>

namespace vernier {
namespace {

const glm::ivec2 kFull(1280, 720);

/// What `scale` has learnt when each of 50 pictures took `ms_per_pixel` for each of its pixels.
InteractiveScale learnt(double ms_per_pixel) {
  InteractiveScale scale(80.0);
  for (int picture = 0; picture < 50; ++picture) {
    const glm::ivec2 size = scale.size(kFull);
    const double pixels = static_cast<double>(size.x) * size.y;
    scale.took(pixels, pixels * ms_per_pixel);
  }
  return scale;
}

TEST(InteractiveScaleTest, AFastDeviceShowsEveryPixel) {
  EXPECT_EQ(learnt(1e-6).size(kFull), kFull);
}

TEST(InteractiveScaleTest, ASlowOneKeepsToTheTime) {
  for (const double ms_per_pixel : {1e-4, 3e-4, 1e-3, 2e-3}) {
    const glm::ivec2 size = learnt(ms_per_pixel).size(kFull);
    // Half a pixel of rounding on each side is less than a percent of these sizes.
    EXPECT_LE(static_cast<double>(size.x) * size.y * ms_per_pixel, 80.0 * 1.01) << ms_per_pixel;
  }
}

TEST(InteractiveScaleTest, NeverCoarserThanASixteenth) {
  EXPECT_EQ(learnt(1e3).size(kFull), glm::ivec2(80, 45));
}

TEST(InteractiveScaleTest, NeverEmpty) {
  EXPECT_EQ(learnt(1e3).size({1, 3}), glm::ivec2(1, 1));
}

TEST(InteractiveScaleTest, SlowerAtOnceFasterByAndBy) {
  InteractiveScale scale = learnt(1e-6);
  scale.took(1000.0, 1000.0);
  EXPECT_EQ(scale.size(kFull), glm::ivec2(80, 45)) << "one late picture is enough";
  scale.took(1000.0, 1e-3);
  EXPECT_EQ(scale.size(kFull), glm::ivec2(80, 45)) << "one early picture is not";
}

TEST(InteractiveScaleTest, NothingIsLearntFromNothing) {
  InteractiveScale scale(80.0);
  const glm::ivec2 before = scale.size(kFull);
  scale.took(0.0, 5.0);
  scale.took(100.0, 0.0);
  EXPECT_EQ(scale.size(kFull), before);
}

}  // namespace
}  // namespace vernier
