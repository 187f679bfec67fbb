#include "cli/parse_values.h"

#include "cli/parse_light.h"
#include "usage_error.h"

namespace vernier {
namespace {

TEST(ParseNumber, DecimalAndFraction) {
  EXPECT_EQ(parse_number("--cutoff", "1/1024"), 0x1p-10);
  EXPECT_EQ(parse_number("--cutoff", "-2.5e3"), -2500.0);
  for (const char* text : {"", "1/", "/2", "1/0", "0/0", "1/2/3", "1 ", " 1", "0x10", "nan", "inf", "1e999", "1,5"}) {
    expect_usage_error("--cutoff", [&] { parse_number("--cutoff", text); });
  }
}

TEST(ParseNumber, LimitsAreIncluded) {
  EXPECT_EQ(parse_number_in("--x", "1", 0.0, 1.0), 1.0);
  EXPECT_EQ(parse_number_in("--x", "0", 0.0, 1.0), 0.0);
  expect_usage_error("from 0 to 1", [] { parse_number_in("--x", "1.0001", 0.0, 1.0); });
}

TEST(ParseCount, DigitsOnlyWithinLimits) {
  EXPECT_EQ(parse_count("--seed", "4294967295", 0, 4294967295u), 4294967295u);
  for (const char* text : {"", "+1", "-1", "1.0", "1e3", "4294967296", "0x1", "1 "}) {
    expect_usage_error("--seed", [&] { parse_count("--seed", text, 0, 4294967295u); });
  }
  expect_usage_error("from 1 to 8", [] { parse_count("--n", "9", 1, 8); });
}

TEST(ParseSize, BothSides) {
  EXPECT_EQ(parse_size("--size", "65536x1"), glm::ivec2(65536, 1));
  for (const char* text : {"65537x1", "0x1", "1x0", "1x", "x1", "1", "1x1x1", "1X1", "-1x1"}) {
    expect_usage_error("--size", [&] { parse_size("--size", text); });
  }
}

TEST(ParseRect, FourNumbers) {
  const PixelRect rect = parse_rect("--crop", "0,5,7,9");
  EXPECT_EQ(rect.x, 0);
  EXPECT_EQ(rect.y, 5);
  EXPECT_EQ(rect.width, 7);
  EXPECT_EQ(rect.height, 9);
  for (const char* text : {"0,0,0,1", "0,0,1,0", "0,0,1", "0,0,1,1,1", "-1,0,1,1", "0,0,65537,1", ",,,"}) {
    expect_usage_error("--crop", [&] { parse_rect("--crop", text); });
  }
}

TEST(ParseVec3, ThreeFiniteNumbers) {
  EXPECT_EQ(parse_vec3("--eye", "-1,2.5,3e2"), glm::dvec3(-1.0, 2.5, 300.0));
  for (const char* text : {"1,2", "1,2,3,4", "1,,3", "1,2,nan", "1,2,inf", "1;2;3", ""}) {
    expect_usage_error("--eye", [&] { parse_vec3("--eye", text); });
  }
}

TEST(ParseColor, NotNegativeAndWithinFloat) {
  EXPECT_EQ(parse_color("--ambient", "0,0.5,8"), glm::vec3(0.0f, 0.5f, 8.0f));
  expect_usage_error("--ambient", [] { parse_color("--ambient", "0,-0.1,0"); });
  expect_usage_error("--ambient", [] { parse_color("--ambient", "0,1e39,0"); });
}

TEST(ParseSampleRange, WithinSpp) {
  const SampleRange range = parse_sample_range("--sample-range", "3:8", 8);
  EXPECT_EQ(range.begin, 3u);
  EXPECT_EQ(range.end, 8u);
  for (const char* text : {"8:8", "3:9", "4:3", "3", "3:", ":3", "0:1:2"}) {
    expect_usage_error("--sample-range", [&] { parse_sample_range("--sample-range", text, 8); });
  }
}

TEST(ParseExposure, HundredStops) {
  EXPECT_EQ(parse_exposure("-3.5"), -3.5f);
  expect_usage_error("--exposure", [] { parse_exposure("100.5"); });
}

TEST(ParseLight, PointAndDirection) {
  const Light point = parse_light("point:1,2,3:4,5,6");
  EXPECT_EQ(point.kind, LightKind::point);
  EXPECT_EQ(point.position, glm::dvec3(1, 2, 3));
  EXPECT_EQ(point.intensity, glm::vec3(4, 5, 6));
  const Light sun = parse_light("dir:0,-1e300,0:1,1,1");
  EXPECT_EQ(sun.kind, LightKind::directional);
  EXPECT_EQ(sun.direction, glm::dvec3(0, -1, 0)) << "unit, without overflow on the way";
}

TEST(ParseLight, RefusesTheRest) {
  for (const char* text : {"", "point", "point:0,0,0", "spot:0,0,0:1,1,1", "dir:0,0,0:1,1,1", "point:0,0,0:-1,0,0",
                           "point:0,0,0:1,1,1:2", "point:0,0:1,1,1"}) {
    expect_usage_error("--light", [&] { parse_light(text); });
  }
}

}  // namespace
}  // namespace vernier
