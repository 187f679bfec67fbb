#include "effects/normal_map_bend.h"

#include <gtest/gtest.h>

#include <bit>
#include <limits>

#include "one_triangle.h"

namespace vernier {
namespace {

Texels bytes(std::uint32_t first, std::uint32_t second) {
  return {TEXTURE_FORMAT_LINEAR8, 2, 1, {first, second}};
}

Texels one_float(float x, float y, float z) {
  return {TEXTURE_FORMAT_FLOAT,
          1,
          1,
          {std::bit_cast<std::uint32_t>(x), std::bit_cast<std::uint32_t>(y), std::bit_cast<std::uint32_t>(z), 0}};
}

TEST(NormalMapBend, bytes_have_no_half) {
  EXPECT_EQ(normal_map_bend(bytes(0xffff8080u, 0xffff8080u), 1.0f), NormalMapBend::alike);
  EXPECT_EQ(normal_map_bend(bytes(0xffff8080u, 0xffff8180u), 1.0f), NormalMapBend::varies);
}

TEST(NormalMapBend, a_factor_of_zero_bends_nothing_that_points_up) {
  EXPECT_EQ(normal_map_bend(bytes(0xffff2030u, 0xff804050u), 0.0f), NormalMapBend::none);
  EXPECT_EQ(normal_map_bend(bytes(0xffff2030u, 0xff7f4050u), 0.0f), NormalMapBend::varies) << "one points down";
}

TEST(NormalMapBend, floats_can_be_flat) {
  EXPECT_EQ(normal_map_bend(one_float(0.5f, 0.5f, 1.0f), 3.0f), NormalMapBend::none);
  EXPECT_EQ(normal_map_bend(one_float(0.5f, 0.5f, 0.0f), 3.0f), NormalMapBend::alike);
  const float infinity = std::numeric_limits<float>::infinity();
  EXPECT_EQ(normal_map_bend(one_float(infinity, 0.5f, 1.0f), 0.0f), NormalMapBend::alike) << "0 times it is no slope";
}

TEST(DetectNormalTexture, is_off_where_it_bends_nothing_and_tells_where_it_nearly_does) {
  Scene scene = white_triangle();
  add_texture(scene, TEXTURE_SLOT_NORMAL);
  scene.textures[0].texels = std::make_shared<Texels>(bytes(0xffff8080u, 0xffff8080u));
  EXPECT_EQ(reason_for(detect_effects(scene, Camera{}, 8), EFFECT_NORMAL_TEXTURE),
            "material 0 (paint): normal texture 0 (checker), the same all over, but not exactly flat");
  scene.materials[0].normal_scale = 0.0f;
  const EffectSet flat = detect_effects(scene, Camera{}, 8);
  EXPECT_EQ(flat.bits & EFFECT_NORMAL_TEXTURE, 0u);
  EXPECT_EQ(reason_for(flat, EFFECT_NORMAL_TEXTURE),
            "material 0 (paint): normal texture 0 (checker); but its texels leave nothing of it");
}

}  // namespace
}  // namespace vernier
