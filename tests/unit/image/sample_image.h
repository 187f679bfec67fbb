#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "image/image.h"

/// A crop with every kind of layer that the renderer writes, in the order that read_image gives layers back.
inline vernier::ImageFile sample_image() {
  constexpr int kWidth = 37, kHeight = 21;  // neither is a multiple of a block
  constexpr std::size_t kPixels = kWidth * kHeight;
  const auto ramp = [](std::size_t channel_count) {
    std::vector<float> values(kPixels * channel_count);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<float>(i * 7 % 101) / 64.0f;
    return values;
  };
  std::vector<float> depth = ramp(1);
  depth[5] = std::numeric_limits<float>::infinity();
  std::vector<float> normal = ramp(3);
  normal[4] = -0.1f;
  std::vector<std::uint32_t> ids(kPixels, 4294967295u);
  ids[3] = 16777217u;  // the first integer that float32 does not hold
  vernier::ImageFile image;
  image.width = kWidth;
  image.height = kHeight;
  image.x = 11;
  image.y = 6;
  image.full_width = 100;
  image.full_height = 60;
  image.layers = {{"", {"R", "G", "B", "A"}, ramp(4)},
                  {"depth", {"Z"}, depth},
                  {"normal", {"X", "Y", "Z"}, normal},
                  {"object_id", {"ID"}, ids}};
  image.metadata = {{"vernier:recipe", "{\"spp\": 16}\nsecond line \\ = end"}, {"vernier:device", "none"}};
  return image;
}
