// Seeded faults of detection: an effect that a scene calls for is off. The comparison that proves auto right, bit for
// bit against all, must see each of them.
#include <variant>

#include "device_test.h"
#include "effects/detect_effects.h"
#include "every_effect.h"
#include "render/render_image.h"

namespace vernier {
namespace {

std::vector<float> colors(const RenderResult& result) {
  return std::get<std::vector<float>>(result.image.layers.front().values);
}

class WrongOffTest : public DeviceTest {
 protected:
  std::vector<float> picture(const std::string& effects) const {
    RenderSettings settings = test::small_image(24, 24, 2);
    settings.effects = effects;
    return colors(render_image(device(), scene_, camera_, settings, {}));
  }

  Scene scene_ = test::every_effect_scene();
  Camera camera_ = test::orthographic_camera();
};

TEST_F(WrongOffTest, the_scene_calls_for_every_effect) {
  for (const EffectReason& effect : detect_effects(scene_, camera_, 8).reasons) EXPECT_TRUE(effect.on) << effect.name;
}

TEST_F(WrongOffTest, each_effect_that_is_left_out_changes_bits_of_the_picture) {
  const std::vector<float> all = picture("all");
  EXPECT_TRUE(picture("auto") == all);
  for (const EffectReason& effect : detect_effects(scene_, camera_, 8).reasons) {
    EXPECT_FALSE(picture("auto,-" + effect.name) == all) << effect.name;
  }
}

TEST_F(WrongOffTest, a_normal_texture_without_slope_and_glass_without_boundary_change_no_bit) {
  scene_ = test::tiny_scene();
  Material& wall = scene_.materials[0];
  Material& mirror = scene_.materials[1];
  Material& glass = scene_.materials[2];
  wall.normal_scale = 0.0f;
  wall.roughness = mirror.roughness = 1.0f;
  glass.ior = 1.0f;
  const std::uint32_t bits = detect_effects(scene_, camera_, 8).bits;
  ASSERT_EQ(bits & (EFFECT_NORMAL_TEXTURE | EFFECT_REFLECTION), 0u);
  ASSERT_NE(bits & EFFECT_REFRACTION, 0u);
  EXPECT_TRUE(picture("auto") == picture("all"));
}

TEST_F(WrongOffTest, textures_of_zeros_leave_no_factor) {
  for (const int slot : {TEXTURE_SLOT_BASE_COLOR, TEXTURE_SLOT_SURFACE, TEXTURE_SLOT_EMISSION,
                         TEXTURE_SLOT_TRANSMISSION, TEXTURE_SLOT_SPECULAR, TEXTURE_SLOT_SPECULAR_COLOR}) {
    scene_ = test::tiny_scene();
    for (Material& material : scene_.materials) {
      for (TextureUse& use : material.textures) use.texture = -1;
    }
    Material& wall = scene_.materials[0];
    wall.metallic = 0.7f;
    wall.specular_strength = 0.9f;
    wall.transmission = glm::vec3(slot == TEXTURE_SLOT_TRANSMISSION ? 0.6f : 0.0f);
    scene_.materials[1].emission = glm::vec3(0.1f);
    const std::vector<float> plain = picture("all");
    wall.textures[slot].texture = test::add_texture(scene_, test::linear_texels(1, 1, {0}));
    const std::vector<float> all = picture("all");
    EXPECT_FALSE(all == plain) << "the texture counts, slot " << slot;
    EXPECT_TRUE(picture("auto") == all) << "slot " << slot;
  }
}

/// Two walls that mirror a quarter of what meets them, far into the picture.
Scene mirror_corridor() {
  Scene scene;
  Material& metal = test::add_black(scene);
  metal.workflow = Workflow::metallic_roughness;
  metal.base_color = glm::vec4(1.0f);
  metal.metallic = 1.0f;
  metal.roughness = 0.5f;
  test::add_polygon(scene, {{-0.3f, -4, 3}, {-0.3f, -4, -20}, {-0.3f, 4, -20}, {-0.3f, 4, 3}});
  test::add_polygon(scene, {{0.3f, -4, -20}, {0.3f, -4, 3}, {0.3f, 4, 3}, {0.3f, 4, -20}});
  scene.environment.sky = scene.environment.ground = glm::vec3(1.0f);
  return scene;
}

TEST_F(WrongOffTest, one_bounce_less_than_needed_changes_bits_of_the_picture) {
  scene_ = mirror_corridor();
  camera_ = test::camera_at(3.5);
  const auto bounded = [&](std::uint32_t max_bounces, const std::string& effects) {
    RenderSettings settings = test::small_image(24, 24, 2);
    settings.cutoff = 0x1p-10f;
    settings.max_bounces = max_bounces;
    settings.effects = effects;
    return render_image(device(), scene_, camera_, settings, {});
  };
  const RenderResult lean = bounded(8, "auto");
  EXPECT_EQ(lean.statistics.effects.depth.bounces, 5u) << "a quarter to the fifth is the cutoff itself";
  const std::vector<float> all = colors(bounded(8, "all"));
  EXPECT_TRUE(colors(lean) == all);
  EXPECT_FALSE(colors(bounded(4, "all")) == all);
}

}  // namespace
}  // namespace vernier
