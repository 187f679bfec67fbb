#include "verify/picture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace vernier {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// Two pixels in a row.
Picture two_pixels(const std::vector<float>& colors) {
  return {.width = 2, .height = 1, .layers = {{"", {"R", "G", "B", "A"}, colors}}};
}

TEST(PixelRay, goes_through_the_centres_of_pixels_row_0_on_top) {
  const Camera camera = looking({1, 2, 3}, {1, 2, 0}, std::numbers::pi / 2.0);
  Picture picture;
  picture.width = picture.height = 2;
  const PixelRay ray = pixel_ray(camera, picture, 0);
  EXPECT_EQ(ray.origin, glm::dvec3(1, 2, 3));
  // Half a side left, half a side up, and one ahead.
  EXPECT_LT(glm::length(ray.direction - glm::normalize(glm::dvec3(-0.5, 0.5, -1.0))), 0x1p-50);
  for (const PixelRay& near : nearby_rays(ray, 1e-3)) {
    EXPECT_NEAR(glm::length(near.direction), 1.0, 0x1p-50);
    EXPECT_LE(glm::length(near.direction - ray.direction), 1e-3);
  }
}

TEST(ForEachPicture, makes_whole_pictures_of_the_samples) {
  CaseSetup setup;
  setup.sample_count = 33;
  std::vector<std::uint64_t> numbers;
  for_each_picture(setup, "case", 4, 8, [&](SampleRandom&, std::uint64_t number) { numbers.push_back(number); });
  EXPECT_EQ(numbers, (std::vector<std::uint64_t>{0, 1, 2}));
  numbers.clear();
  for_each_picture(setup, "case", 4, 2, [&](SampleRandom&, std::uint64_t number) { numbers.push_back(number); });
  EXPECT_EQ(numbers.size(), 2u);
}

TEST(BookPixels, a_pixel_that_is_not_finite_fails_whatever_the_case_says) {
  Tally tally;
  book_pixels(tally, two_pixels({1, 1, 1, 1, 0, kNan, 0, 1}), [](std::size_t) { return true; });
  EXPECT_EQ(tally.result().samples, 2u);
  EXPECT_EQ(tally.result().failures, 1u);
  EXPECT_EQ(tally.result().first_failure, 1u);
  EXPECT_NE(tally.result().worst_inputs.find("pixel 1,0"), std::string::npos);
}

TEST(BookPixels, no_pixel_counts_where_rays_were_dropped) {
  Picture picture = two_pixels(std::vector<float>(8, 0.0f));
  picture.dropped_rays = 1;
  Tally tally("absolute", 1.0);
  book_pixel_errors(tally, picture, [](std::size_t) { return 0.0; });
  EXPECT_EQ(tally.result().failures, 2u);
}

TEST(SameBits, tells_minus_zero_and_alpha_apart) {
  const Picture picture = two_pixels({0, 0, 0, 1, kNan, 0, 0, 1});
  EXPECT_TRUE(same_bits(picture, picture, 1));
  EXPECT_FALSE(same_bits(picture, two_pixels({-0.0f, 0, 0, 1, 0, 0, 0, 1}), 0));
  EXPECT_FALSE(same_bits(picture, two_pixels({0, 0, 0, 0.5f, 0, 0, 0, 1}), 0));
}

TEST(BoxMesh, is_closed_and_wound_outwards) {
  const VerifyMesh box = box_mesh({-1, -2, -3}, {1, 2, 3});
  ASSERT_EQ(box.triangles.size(), 12u);
  double volume = 0.0;
  for (const glm::uvec3& t : box.triangles) {
    const glm::dvec3 a = box.positions[t.x], b = box.positions[t.y], c = box.positions[t.z];
    volume += glm::dot(a, glm::cross(b, c)) / 6.0;
    EXPECT_GT(glm::dot(glm::cross(b - a, c - a), a), 0.0);
  }
  EXPECT_DOUBLE_EQ(volume, 48.0);  // 2 x 4 x 6
}

TEST(Rotation, keeps_lengths_and_handedness) {
  SampleRandom random(1, "case", 2);
  const glm::dmat3 turn(rotation(random));
  EXPECT_NEAR(glm::determinant(turn), 1.0, 1e-14);
  EXPECT_NEAR(glm::length(turn * glm::dvec3(3, 4, 12)), 13.0, 1e-13);
}

}  // namespace
}  // namespace vernier
