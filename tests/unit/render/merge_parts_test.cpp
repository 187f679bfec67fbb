#include "render/merge_parts.h"

#include <gtest/gtest.h>

#include "render/film_layer.h"
#include "shared/film_layout.h"
#include "unit/image/expect_error.h"

namespace vernier {
namespace {

/// A crop of an image of 4 x 2 pixels whose red is 10 x + y, with all its samples.
ImagePart crop(const std::string& name, int x, int y, int width, int height) {
  ImagePart part{name, {}, 0, 4};
  part.image = {.width = width,
                .height = height,
                .x = x,
                .y = y,
                .full_width = 4,
                .full_height = 2,
                .layers = {},
                .metadata = {}};
  std::vector<float> values;
  for (int row = y; row < y + height; ++row) {
    for (int column = x; column < x + width; ++column) {
      values.insert(values.end(), {10.0f * column + row, 0.0f, 0.0f, 1.0f});
    }
  }
  part.image.layers.push_back({"", {"R", "G", "B", "A"}, values});
  return part;
}

/// Samples of one pixel, `red` each, with their film.
ImagePart samples(const std::string& name, std::uint32_t begin, std::uint32_t end, std::uint32_t red) {
  ImagePart part{name, {}, begin, end};
  part.image = {
      .width = 1, .height = 1, .x = 0, .y = 0, .full_width = 1, .full_height = 1, .layers = {}, .metadata = {}};
  std::vector<std::uint32_t> sums(FILM_WORDS);
  sums[FILM_SAMPLES] = end - begin;
  sums[FILM_RED + 1] = (end - begin) * red << (FILM_FRACTION_BITS - 32);
  part.image.layers.push_back({"", {"R", "G", "B", "A"}, std::vector<float>(4)});
  part.image.layers.push_back(film_layer(sums));
  return part;
}

const std::vector<float>& colors(const ImageFile& image) {
  return std::get<std::vector<float>>(image.layers.front().values);
}

TEST(MergeParts, CropsGoToTheirPlacesInAnyOrder) {
  const ImageFile image = merge_parts({crop("a", 1, 1, 3, 1), crop("b", 0, 0, 4, 1), crop("c", 0, 1, 1, 1)}, 4, {});
  EXPECT_EQ(image.width, 4);
  EXPECT_EQ(image.full_height, 2);
  EXPECT_EQ(colors(image), colors(crop("whole", 0, 0, 4, 2).image));
}

TEST(MergeParts, SamplesAreSummedBeforeTheyAreDivided) {
  const ImageFile image = merge_parts({samples("b", 1, 4, 8), samples("a", 0, 1, 4)}, 4, {});
  EXPECT_EQ(colors(image)[0], 7.0f);  // (4 + 3 x 8) / 4
  EXPECT_EQ(image.layers.size(), 1u) << "the film is no layer of the whole";
}

TEST(MergeParts, WhatOverlapsOrIsMissingIsNamed) {
  const auto expect_refused = [](const std::string& line, const std::vector<ImagePart>& parts) {
    expect_error(ErrorKind::refused, line, [&] { merge_parts(parts, 4, {}); });
  };
  expect_refused("b: holds samples that a holds too, the first of them: pixel 1,1, sample 0",
                 {crop("a", 0, 0, 2, 2), crop("b", 1, 1, 3, 1)});
  expect_refused("b: holds samples that a holds too, the first of them: pixel 0,0, sample 2",
                 {samples("a", 0, 3, 1), samples("b", 2, 4, 1)});
  expect_refused("parts are missing: none holds pixel 1,1, sample 0 of 4",
                 {crop("a", 0, 0, 4, 1), crop("b", 0, 1, 1, 1), crop("c", 2, 1, 2, 1)});
  expect_refused("parts are missing: none holds pixel 0,0, sample 1 of 4",
                 {samples("a", 0, 1, 1), samples("b", 2, 4, 1)});
}

TEST(MergeParts, PartsThatAreNotWhatTheyClaimAreRefused) {
  const auto expect_refused = [](const std::string& line, const ImagePart& part) {
    expect_error(ErrorKind::refused, line, [&] { merge_parts({samples("a", 0, 3, 1), part}, 4, {}); });
  };
  ImagePart part = samples("b", 3, 4, 1);
  auto& words = std::get<std::vector<std::uint32_t>>(part.image.layers[1].values);
  words[FILM_SAMPLES] = 0;
  expect_refused("b: lacks samples of pixel 0,0", part);
  words[FILM_SAMPLES] = 1;
  words[FILM_BLUE + 2] = FILM_PLAIN_SUM;
  expect_refused("b: has sums of floats", part);
  part.image.layers.pop_back();
  expect_refused("b: has a part of the samples, but not the layers film.*", part);
  part.image.layers.front().channels.back() = "Z";
  expect_refused("b: lacks colours", part);
  part.image.full_width = 2;
  expect_refused("b: is of 2x1 pixels, a of 1x1", part);
  part = samples("b", 3, 5, 1);
  expect_refused("b: has samples beyond the 4 of the image", part);
  part = samples("b", 3, 4, 1);
  part.image.x = 1;
  expect_refused("b: reaches beyond its full image", part);
}

// The file says how large the full image is, not how large it can be.
TEST(MergeParts, AbsurdFullSizesTakeNoMemory) {
  ImagePart part = crop("a", 0, 0, 4, 2);
  part.image.full_width = part.image.full_height = 65536;
  expect_error(ErrorKind::refused, "none holds pixel 4,0, sample 0 of 4", [&] { merge_parts({part}, 4, {}); });
  part.image.full_width = 1 << 30;
  expect_error(ErrorKind::refused, "a: is of too large an image", [&] { merge_parts({part}, 4, {}); });
}

}  // namespace
}  // namespace vernier
