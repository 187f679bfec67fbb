#include "scene/height_map.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "scene/texel_color.h"

namespace vernier {
namespace {

Texels grey8(std::uint32_t width, std::uint32_t height, const std::vector<std::uint32_t>& bytes) {
  Texels texels{TEXTURE_FORMAT_SRGB8, width, height, {}};
  for (const std::uint32_t b : bytes) texels.words.push_back(b | b << 8 | b << 16 | 0xff000000u);
  return texels;
}

glm::vec3 normal_at(const Texels& normals, std::size_t i) {
  return glm::vec3(texel_color(normals, i)) * 2.0f - 1.0f;
}

TEST(HeightMap, FlatIsExactlyUp) {
  const Texels normals = normals_from_heights(grey8(2, 2, {77, 77, 77, 77}), 3.0, TEXTURE_WRAP_REPEAT);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(normal_at(normals, i), glm::vec3(0, 0, 1));
}

TEST(HeightMap, SlopesPointAwayFromTheRise) {
  // Rises from 0 to 1 over two texels to the right: slope 1/2 in the middle, n = unit(-strength / 2, 0, 1).
  const Texels ramp = normals_from_heights(scalar_map(grey8(3, 1, {0, 100, 255}), 'l'), 2.0, TEXTURE_WRAP_CLAMP);
  EXPECT_NEAR(normal_at(ramp, 1).x, -std::sqrt(0.5), 1e-6);
  EXPECT_NEAR(normal_at(ramp, 1).z, std::sqrt(0.5), 1e-6);
  // Rises downwards in the image: falls along v upwards, so the normal leans to +y.
  const Texels down = normals_from_heights(scalar_map(grey8(1, 3, {0, 100, 255}), 'l'), 2.0, TEXTURE_WRAP_CLAMP);
  EXPECT_NEAR(normal_at(down, 1).y, std::sqrt(0.5), 1e-6);
}

TEST(HeightMap, BorderFollowsTheWrap) {
  const Texels heights = scalar_map(grey8(3, 1, {0, 0, 255}), 'l');
  // Repeated, the left neighbour of the first texel is the last one.
  EXPECT_NEAR(normal_at(normals_from_heights(heights, 2.0, TEXTURE_WRAP_REPEAT), 0).x, std::sqrt(0.5), 1e-6);
  EXPECT_EQ(normal_at(normals_from_heights(heights, 2.0, TEXTURE_WRAP_CLAMP), 0).x, 0.0f);
}

TEST(ScalarMap, PicksTheChannelAsStored) {
  const Texels texels{TEXTURE_FORMAT_SRGB8, 1, 1, {0x80402010u}};
  const auto value = [&](char channel) { return scalar_map(texels, channel).words[0]; };
  EXPECT_EQ(value('r'), 0xff101010u);
  EXPECT_EQ(value('g'), 0xff202020u);
  EXPECT_EQ(value('b'), 0xff404040u);
  EXPECT_EQ(value('m'), 0xff808080u);
  EXPECT_EQ(value('l'), 0xff252525u);   // (16 + 32 + 64) / 3
  EXPECT_EQ(value('\0'), 0xff808080u);  // there is transparency
  EXPECT_EQ(scalar_map({TEXTURE_FORMAT_SRGB8, 1, 1, {0xff404040u}}, '\0').words[0], 0xff404040u);
  EXPECT_EQ(scalar_map(texels, 'r').format, TEXTURE_FORMAT_LINEAR8);
}

TEST(ScalarMap, KeepsFloats) {
  Texels texels{TEXTURE_FORMAT_FLOAT, 1, 1, {}};
  for (const float f : {0.1f, 0.2f, 3.0f, 1.0f}) texels.words.push_back(std::bit_cast<std::uint32_t>(f));
  EXPECT_EQ(texel_color(scalar_map(texels, 'b'), 0), glm::vec4(3.0f, 3.0f, 3.0f, 1.0f));
}

}  // namespace
}  // namespace vernier
