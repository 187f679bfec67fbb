#include "image/display_picture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "image/srgb_curve.h"

namespace vernier {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr std::uint32_t kMiss = 4294967295u;

std::vector<float> shown(const Layer& layer, int width, float exposure_ev = 0.0f) {
  return display_picture(layer, width, 1, DisplayTransform{exposure_ev}).values;
}

TEST(DisplayPicture, ColorTakesExposureClampAndCurve) {
  const Layer color{"", {"R", "G", "B", "A"}, std::vector<float>{0.25f, -1.0f, 3.0f, 0.0f}};
  const float quarter = static_cast<float>(srgb_from_linear(0.25));
  const float half = static_cast<float>(srgb_from_linear(0.5));
  EXPECT_EQ(shown(color, 1), (std::vector<float>{quarter, 0.0f, 1.0f}));
  EXPECT_EQ(shown(color, 1, 1.0f), (std::vector<float>{half, 0.0f, 1.0f}));
}

TEST(DisplayPicture, ExposureIsForTheColorLayerOnly) {
  const Layer albedo{"albedo", {"R", "G", "B"}, std::vector<float>{0.25f, 0.25f, 0.25f}};
  EXPECT_EQ(shown(albedo, 1, 1.0f), shown(albedo, 1, 0.0f));
}

TEST(DisplayPicture, FindsChannelsByNameInAnyOrder) {
  const Layer color{"", {"B", "A", "G", "R"}, std::vector<float>{0.0f, 0.5f, 0.0f, 1.0f}};
  EXPECT_EQ(shown(color, 1), (std::vector<float>{1.0f, 0.0f, 0.0f}));
}

TEST(DisplayPicture, NonFiniteIsMagenta) {
  const std::vector<float> magenta = {1.0f, 0.0f, 1.0f};
  for (const float value : {kNan, kInfinity, -kInfinity})
    EXPECT_EQ(shown(Layer{"", {"R", "G", "B"}, std::vector<float>{0.0f, value, 0.0f}}, 1), magenta);
  EXPECT_EQ(shown(Layer{"depth", {"Z"}, std::vector<float>{kNan}}, 1), magenta);
  EXPECT_EQ(shown(Layer{"depth", {"Z"}, std::vector<float>{-kInfinity}}, 1), magenta);
}

TEST(DisplayPicture, DepthIsBrightNearbyAndBlackForMisses) {
  const std::vector<float> values = shown(Layer{"depth", {"Z"}, std::vector<float>{2.0f, 3.0f, 4.0f, kInfinity}}, 4);
  EXPECT_EQ(values[0], 1.0f);
  EXPECT_FLOAT_EQ(values[3], 0.55f);
  EXPECT_FLOAT_EQ(values[6], 0.1f);
  EXPECT_EQ(values[9], 0.0f);
}

TEST(DisplayPicture, DepthOfOneValueOrNone) {
  EXPECT_EQ(shown(Layer{"depth", {"Z"}, std::vector<float>{5.0f}}, 1)[0], 1.0f);
  EXPECT_EQ(shown(Layer{"depth", {"Z"}, std::vector<float>{kInfinity}}, 1)[0], 0.0f);
}

TEST(DisplayPicture, DirectionsPositionsAndUvs) {
  const Layer normal{"shading_normal", {"X", "Y", "Z"}, std::vector<float>{-1.0f, 0.0f, 1.0f}};
  EXPECT_EQ(shown(normal, 1), (std::vector<float>{0.0f, 0.5f, 1.0f}));
  const Layer position{"position", {"X", "Y", "Z"}, std::vector<float>{-4.0f, 1.0f, 7.0f, 4.0f, 1.0f, 8.0f}};
  EXPECT_EQ(shown(position, 2), (std::vector<float>{0.0f, 0.0f, 0.0f, 1.0f, 0.0f, 1.0f}));
  const Layer uv{"uv", {"U", "V"}, std::vector<float>{1.25f, -0.25f}};
  EXPECT_EQ(shown(uv, 1), (std::vector<float>{0.25f, 0.75f, 0.0f}));
}

TEST(DisplayPicture, IdsAreDistinctAndMissesBlack) {
  constexpr int kCount = 64;
  std::vector<std::uint32_t> ids;
  for (std::uint32_t id = 0; id < kCount - 1; ++id) ids.push_back(id);
  ids.push_back(kMiss);
  const std::vector<float> values = shown(Layer{"object_id", {"ID"}, ids}, kCount);
  for (int i = 0; i < kCount; ++i)
    for (int j = 0; j < i; ++j) {
      const double distance = std::fabs(values[i * 3] - values[j * 3]) +
                              std::fabs(values[i * 3 + 1] - values[j * 3 + 1]) +
                              std::fabs(values[i * 3 + 2] - values[j * 3 + 2]);
      EXPECT_GT(distance, 4.0 / 255.0) << i << " and " << j;
    }
  EXPECT_EQ(values[(kCount - 1) * 3], 0.0f);
}

TEST(DisplayPicture, AmountsAreRelativeToTheLargest) {
  const Layer count{"sample_count", {"N"}, std::vector<std::uint32_t>{4, 16}};
  EXPECT_EQ(shown(count, 2), (std::vector<float>{0.25f, 0.25f, 0.25f, 1.0f, 1.0f, 1.0f}));
}

TEST(UnsignedPicture, KeepsValuesThatTheFormatCanHold) {
  const Layer color{"", {"R", "G", "B"}, std::vector<float>{100.0f, -1.0f, 0.5f, kNan, 0.0f, 0.0f}};
  EXPECT_EQ(unsigned_picture(color, 2, 1).values, (std::vector<float>{100.0f, 0.0f, 0.5f, 1.0f, 0.0f, 1.0f}));
  const Layer depth{"depth", {"Z"}, std::vector<float>{7.0f, kInfinity}};
  EXPECT_EQ(unsigned_picture(depth, 2, 1).values, (std::vector<float>{7.0f, 7.0f, 7.0f, 0.0f, 0.0f, 0.0f}));
  const Layer normal{"normal", {"X", "Y", "Z"}, std::vector<float>{-1.0f, 0.0f, 1.0f}};
  EXPECT_EQ(unsigned_picture(normal, 1, 1).values, (std::vector<float>{0.0f, 0.5f, 1.0f}));
}

}  // namespace
}  // namespace vernier
