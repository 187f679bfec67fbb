#include "reference/textures.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "test_scenes.h"

namespace vernier::reference {
namespace {

// Red 0, 51, 102, 255 (0, 0.2, 0.4, 1) from left to right.
const std::shared_ptr<const Texels> kRamp =
    test::linear_texels(4, 1, {0xff000000u, 0xff000033u, 0xff000066u, 0xff0000ffu});

double red(std::uint32_t wrap, std::uint32_t filter, double u) {
  return sample_texels(*kRamp, {wrap, wrap, filter}, {u, 0.5}).x;
}

TEST(SampleTexels, NearestRepeats) {
  const auto at = [](double u) { return red(TEXTURE_WRAP_REPEAT, TEXTURE_FILTER_NEAREST, u); };
  EXPECT_DOUBLE_EQ(at(0.0), 0.0);
  EXPECT_DOUBLE_EQ(at(0.26), 0.2);
  EXPECT_DOUBLE_EQ(at(1.0), 0.0);
  EXPECT_DOUBLE_EQ(at(-0.01), 1.0);
  EXPECT_DOUBLE_EQ(at(7.6), 0.4);
}

TEST(SampleTexels, NearestClamps) {
  const auto at = [](double u) { return red(TEXTURE_WRAP_CLAMP, TEXTURE_FILTER_NEAREST, u); };
  EXPECT_DOUBLE_EQ(at(-3.0), 0.0);
  EXPECT_DOUBLE_EQ(at(1.0), 1.0);
  EXPECT_DOUBLE_EQ(at(9.0), 1.0);
}

TEST(SampleTexels, NearestMirrors) {
  const auto at = [](double u) { return red(TEXTURE_WRAP_MIRROR, TEXTURE_FILTER_NEAREST, u); };
  EXPECT_DOUBLE_EQ(at(1.1), 1.0);
  EXPECT_DOUBLE_EQ(at(1.3), 0.4);
  EXPECT_DOUBLE_EQ(at(-0.3), 0.2);
  EXPECT_DOUBLE_EQ(at(2.3), 0.2);
}

TEST(SampleTexels, LinearBlendsBetweenCentres) {
  for (const std::uint32_t wrap : {TEXTURE_WRAP_REPEAT, TEXTURE_WRAP_CLAMP, TEXTURE_WRAP_MIRROR}) {
    EXPECT_DOUBLE_EQ(red(wrap, TEXTURE_FILTER_LINEAR, 0.375), 0.2);  // a centre
    EXPECT_DOUBLE_EQ(red(wrap, TEXTURE_FILTER_LINEAR, 0.5), 0.3);    // half way
  }
}

TEST(SampleTexels, LinearAtTheBorder) {
  EXPECT_DOUBLE_EQ(red(TEXTURE_WRAP_REPEAT, TEXTURE_FILTER_LINEAR, 0.0),
                   0.5);  // half of the last texel, half of the first
  EXPECT_DOUBLE_EQ(red(TEXTURE_WRAP_CLAMP, TEXTURE_FILTER_LINEAR, 0.0), 0.0);
  EXPECT_DOUBLE_EQ(red(TEXTURE_WRAP_MIRROR, TEXTURE_FILTER_LINEAR, 1.0), 1.0);
  EXPECT_DOUBLE_EQ(red(TEXTURE_WRAP_MIRROR, TEXTURE_FILTER_LINEAR, 0.0), 0.0);
}

TEST(SampleTexels, LinearIsBilinear) {
  const auto texels = test::linear_texels(2, 2, {0x00u, 0x33u, 0x66u, 0xffu});
  const Sampler clamp{TEXTURE_WRAP_CLAMP, TEXTURE_WRAP_CLAMP, TEXTURE_FILTER_LINEAR};
  // A quarter of the way right, half of the way down: (0.75 (0 + 0.4) + 0.25 (0.2 + 1)) / 2.
  EXPECT_NEAR(sample_texels(*texels, clamp, {0.375, 0.5}).x, 0.3, 1e-15);
}

TEST(SampleTexels, NonFiniteReadsTheFirstTexel) {
  const auto texels = test::linear_texels(2, 1, {0xffu, 0x33u});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(sample_texels(*texels, {}, {nan, 0.5}).x, 1.0);
  EXPECT_EQ(sample_texels(*texels, {}, {0.9, infinity}).x, 1.0);
}

TEST(Texel, SrgbDecodesColourButNotAlpha) {
  const Texels texels{TEXTURE_FORMAT_SRGB8, 1, 1, {0x80ff0abcu}};
  const glm::dvec4 value = texel(texels, 0, 0);
  EXPECT_NEAR(value.x, std::pow((188.0 / 255.0 + 0.055) / 1.055, 2.4), 1e-15);
  EXPECT_NEAR(value.y, 10.0 / 255.0 / 12.92, 1e-15);
  EXPECT_DOUBLE_EQ(value.z, 1.0);
  EXPECT_DOUBLE_EQ(value.w, 128.0 / 255.0);
}

TEST(Texel, FloatTexelsHaveFourWords) {
  Texels texels{TEXTURE_FORMAT_FLOAT, 2, 1, {}};
  for (int i = 0; i < 8; ++i) texels.words.push_back(std::bit_cast<std::uint32_t>(i * 1.5f));
  EXPECT_EQ(texel(texels, 1, 0), glm::dvec4(6.0, 7.5, 9.0, 10.5));
}

}  // namespace
}  // namespace vernier::reference
