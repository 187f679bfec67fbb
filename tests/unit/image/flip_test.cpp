#include "image/flip.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "expect_error.h"
#include "image/flip_color.h"
#include "image/flip_filters.h"

namespace vernier {
namespace {

// Both sides add up about 40 products in single precision: some 2^-21 of the largest value. The root in the exponent
// 0.7 and the stretch by 0.95 / 0.4 enlarge that where a difference is small, by less than 20: 1e-5.
constexpr double kTolerance = 1e-5;

Image constant(float red, float green, float blue, int width = 30, int height = 20) {
  Image image{width, height, 3, {}};
  for (int i = 0; i < width * height; ++i) image.values.insert(image.values.end(), {red, green, blue});
  return image;
}

// Ramps, a fine texture and a checkerboard; all values are dyadic, so that any other program gets the same bits.
Image pattern() {
  Image image{48, 32, 3, {}};
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      image.values.push_back(static_cast<float>((x * 5 + y * 3) % 64) / 64.0f);
      image.values.push_back(static_cast<float>((x * y) % 97) / 128.0f);
      image.values.push_back(static_cast<float>((x / 8 + y / 8) % 2) * 0.75f + 0.125f);
    }
  return image;
}

// A darker rectangle and a white pixel, then everything one pixel to the right, the last column first.
Image changed(Image image) {
  const Image source = image;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (int c = 0; c < 3; ++c) {
        const int from = (x + image.width - 1) % image.width;
        float value = source.values[(y * image.width + from) * 3 + c];
        if (y >= 8 && y < 20 && from >= 12 && from < 30) value *= 0.75f;
        if (y == 24 && from == 40) value = 1.0f;
        image.values[(y * image.width + x) * 3 + c] = value;
      }
  return image;
}

// Expected values: flip-evaluator 1.7 (the authors' package), evaluate(a, b, "LDR", inputsRGB=False,
// applyMagma=False, parameters={"ppd": ...}) on the same values.
TEST(Flip, AgreesWithTheAuthorsProgram) {
  const FlipError error = flip(pattern(), changed(pattern()));
  EXPECT_NEAR(error.mean, 0.332267642, kTolerance);
  EXPECT_NEAR(error.p99, 0.81072414, kTolerance);
  EXPECT_NEAR(error.map[16 * 48 + 20], 0.35900295, kTolerance);
  EXPECT_NEAR(error.map[24 * 48 + 41], 0.27860537, kTolerance);
}

TEST(Flip, AgreesWithTheAuthorsProgramFromNearerBy) {
  EXPECT_NEAR(flip(pattern(), changed(pattern()), 0.0f, 20.0).mean, 0.618576303, kTolerance);
}

TEST(Flip, OfEqualImagesIsExactlyZero) {
  const FlipError error = flip(pattern(), pattern());
  EXPECT_EQ(error.mean, 0.0);
  EXPECT_EQ(error.p99, 0.0);
}

// Green and blue are the two colours that the scale is made for.
TEST(Flip, OfGreenAgainstBlueIsOne) {
  EXPECT_NEAR(flip(constant(0, 1, 0), constant(0, 0, 1)).mean, 1.0, kTolerance);
}

// Without features and with nothing to blur: HyAB is 100 - 0 = 100 in lightness alone, so with m the distance of green
// and blue to the power 0.7 the error is 0.95 + 0.05 (100^0.7 - 0.4 m) / (0.6 m).
TEST(Flip, OfBlackAgainstWhiteFollowsFromTheDefinition) {
  const double largest =
      std::pow(hyab_distance(hunt_lab_from_linear({0.0, 1.0, 0.0}), hunt_lab_from_linear({0.0, 0.0, 1.0})), 0.7);
  const double expected = 0.95 + 0.05 * (std::pow(100.0, 0.7) - 0.4 * largest) / (0.6 * largest);
  EXPECT_NEAR(flip(constant(0, 0, 0), constant(1, 1, 1)).mean, expected, kTolerance);
}

TEST(Flip, ClampsAfterTheExposure) {
  EXPECT_EQ(flip(constant(4, 4, 4), constant(1, 1, 1)).mean, 0.0);
  EXPECT_GT(flip(constant(4, 4, 4), constant(1, 1, 1), -2.0f).mean, 0.1);
  EXPECT_EQ(flip(constant(0.25f, 0.25f, 0.25f), constant(0.125f, 0.125f, 0.125f), 3.0f).mean, 0.0);
}

TEST(Flip, ShowsNonFinitePixelsAsMagenta) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const FlipError error = flip(constant(0, 0, 0), constant(0, nan, 0));
  EXPECT_EQ(error.mean, flip(constant(0, 0, 0), constant(1, 0, 1)).mean);
  EXPECT_GT(error.mean, 0.5);
}

// At one pixel per degree no filter reaches a neighbour, so only the changed pixels differ. The rank of 100 pixels is
// the 99th: one changed pixel is above it, two are not.
TEST(Flip, PercentileIsByNearestRank) {
  const Image black = constant(0, 0, 0, 100, 1);
  Image test = black;
  for (int c = 0; c < 3; ++c) test.values[30 * 3 + c] = 1.0f;
  const FlipError one = flip(black, test, 0.0f, 1.0);
  EXPECT_LT(one.p99, 0.01);
  EXPECT_GT(one.map[30], 0.9f);
  for (int c = 0; c < 3; ++c) test.values[70 * 3 + c] = 1.0f;
  EXPECT_GT(flip(black, test, 0.0f, 1.0).p99, 0.9);
}

TEST(Flip, WorksOnASinglePixel) {
  EXPECT_GT(flip(constant(0, 0, 0, 1, 1), constant(1, 1, 1, 1, 1)).mean, 0.9);
}

TEST(Flip, RefusesWhatItCannotCompare) {
  const Image image = constant(0, 0, 0);
  expect_error(ErrorKind::usage, "sizes differ", [&] { flip(image, constant(0, 0, 0, 1, 1)); });
  expect_error(ErrorKind::usage, "pixels per degree", [&] { flip(image, image, 0.0f, 0.0); });
  expect_error(ErrorKind::usage, "exposure", [&] { flip(image, image, NAN); });
}

TEST(FlipColor, WhiteAndBlackHaveNoHue) {
  const Color3 white = ycxcz_from_linear({1.0, 1.0, 1.0});
  EXPECT_NEAR(white[0], 100.0, 1e-12);
  EXPECT_NEAR(white[1], 0.0, 1e-12);
  EXPECT_NEAR(white[2], 0.0, 1e-12);
  const Color3 black = hunt_lab_from_linear({0.0, 0.0, 0.0});
  EXPECT_NEAR(black[0], 0.0, 1e-12);
}

TEST(FlipColor, YcxczInverts) {
  const Color3 linear = linear_from_ycxcz(ycxcz_from_linear({0.1, 0.7, 0.3}));
  EXPECT_NEAR(linear[0], 0.1, 1e-13);
  EXPECT_NEAR(linear[1], 0.7, 1e-13);
  EXPECT_NEAR(linear[2], 0.3, 1e-13);
}

TEST(FlipFilters, KeepConstantsAndFindNoFeaturesInThem) {
  for (const Opponent channel : {Opponent::luminance, Opponent::red_green, Opponent::blue_yellow}) {
    double total = 0.0;
    for (const Weights& weights : contrast_filter(channel, kFlipPixelsPerDegree)) {
      double sum = 0.0;
      for (const double weight : weights) sum += weight;
      total += sum * sum;
    }
    EXPECT_NEAR(total, 1.0, 1e-12);
  }
  const FeatureWeights weights = feature_weights(kFlipPixelsPerDegree);
  double edge = 0.0, point = 0.0;
  for (const double weight : weights.edge) edge += weight;
  for (const double weight : weights.point) point += weight;
  EXPECT_NEAR(edge, 0.0, 1e-12);
  EXPECT_NEAR(point, 0.0, 1e-12);
}

// Weights 1, 2, 4 across on the row 1 0 2, borders repeated: 1 + 2 + 0, 1 + 0 + 8, 0 + 4 + 8.
TEST(FilterPlane, RepeatsTheBorder) {
  const Plane plane{3, 1, {1.0f, 0.0f, 2.0f}};
  EXPECT_EQ(filter_plane(plane, {1, 2, 4}, {1}).values, (std::vector<float>{3.0f, 9.0f, 12.0f}));
  const Plane column{1, 3, {1.0f, 0.0f, 2.0f}};
  EXPECT_EQ(filter_plane(column, {1}, {1, 2, 4}).values, (std::vector<float>{3.0f, 9.0f, 12.0f}));
}

}  // namespace
}  // namespace vernier
