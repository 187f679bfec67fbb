#include "image/layer_differences.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vernier {
namespace {

ImageFile some_image() {
  ImageFile image{
      .width = 2, .height = 2, .x = 3, .y = 4, .full_width = 9, .full_height = 9, .layers = {}, .metadata = {}};
  image.layers.push_back({"", {"R", "G"}, std::vector<float>{0.0f, 1.0f, 2.0f, std::nanf(""), 4.0f, 5.0f, 6.0f, 7.0f}});
  image.layers.push_back({"n", {"N"}, std::vector<std::uint32_t>{1, 2, 3, 4}});
  return image;
}

using Lines = std::vector<std::string>;

TEST(LayerDifferences, NoneBetweenEqualBitsInAnyOrderOfLayers) {
  ImageFile other = some_image();
  std::swap(other.layers[0], other.layers[1]);
  EXPECT_EQ(layer_differences(some_image(), other), Lines{});
}

TEST(LayerDifferences, CountAndFirstPlaceOfThoseInALayer) {
  ImageFile other = some_image();
  std::get<std::vector<float>>(other.layers[0].values)[5] = 5.5f;
  std::get<std::vector<float>>(other.layers[0].values)[6] = 0.0f;
  EXPECT_EQ(layer_differences(some_image(), other),
            Lines{"colour: 2 of 4 pixels differ, the first: pixel 3,5, G 5.5 instead of 5"});
  other = some_image();
  std::get<std::vector<float>>(other.layers[0].values)[0] = -0.0f;
  EXPECT_EQ(layer_differences(some_image(), other).size(), 1u) << "equal numbers, other bits";
}

TEST(LayerDifferences, LayersAndSizesThatOnlyOneHas) {
  ImageFile other = some_image();
  other.layers[1].name = "m";
  EXPECT_EQ(layer_differences(some_image(), other), (Lines{"layer `n`: is not there", "layer `m`: is new"}));
  other = some_image();
  other.layers[1].channels[0] = "M";
  EXPECT_EQ(layer_differences(some_image(), other), Lines{"layer `n`: has other channels"});
  other.x = 2;
  EXPECT_EQ(layer_differences(some_image(), other),
            Lines{"2x2 pixels at 2,4 of 9x9 instead of 2x2 pixels at 3,4 of 9x9"});
}

}  // namespace
}  // namespace vernier
