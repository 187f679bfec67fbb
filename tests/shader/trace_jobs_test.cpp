#include <gtest/gtest.h>

#include "effects/detect_effects.h"
#include "reference/render_reference.h"
#include "render/develop.h"
#include "shader/trace_on_cpu.h"

namespace vernier::shader {
namespace {

std::vector<float> color_on_cpu(const Scene& scene, const Camera& camera, const RenderSettings& settings) {
  const PackedScene packed = test::packed_for(scene, camera, settings);
  return develop(film_on_cpu(packed, settings), {0, 0, settings.width, settings.height}).color;
}

TEST(TraceJobs, a_picture_of_every_effect_is_the_reference_s) {
  const RenderSettings settings = test::small_image(24, 24, 4);
  const Scene scene = test::tiny_scene();
  const std::vector<float> color = color_on_cpu(scene, test::camera_at(3.5), settings);
  ReferenceSettings exact;
  exact.width = exact.height = 24;
  exact.spp = 4;
  exact.thread_count = 1;
  const ImageFile reference = render_reference(scene, test::camera_at(3.5), exact, {});
  const auto& expected = std::get<std::vector<float>>(reference.layers[0].values);
  ASSERT_EQ(expected.size(), color.size());
  // Floats against doubles: where a ray meets another triangle or texel by rounding, single pixels may differ;
  // elsewhere a path of eight surfaces has some hundred roundings of 2^-24.
  int different = 0;
  for (std::size_t i = 0; i < color.size(); ++i) {
    different += std::abs(color[i] - expected[i]) > 1e-4f * std::max(1.0f, expected[i]) ? 1 : 0;
  }
  EXPECT_LE(different, static_cast<int>(color.size()) / 100);
}

TEST(TraceJobs, any_search_budget_gives_the_same_bits) {
  const RenderSettings settings = test::small_image(12, 12, 4);
  const PackedScene packed = test::packed_for(test::tiny_scene(), test::camera_at(3.5), settings);
  const std::vector<std::uint32_t> film = film_on_cpu(packed, settings);
  for (std::uint32_t budget : {1u, 2u, 7u}) EXPECT_EQ(film_on_cpu(packed, settings, budget), film) << budget;
}

TEST(TraceJobs, any_number_of_invocations_gives_the_same_bits) {
  const RenderSettings settings = test::small_image(11, 9, 3);  // blocks of 8 are not full
  const PackedScene packed = test::packed_for(test::tiny_scene(), test::camera_at(3.5), settings);
  const std::vector<std::uint32_t> film = film_on_cpu(packed, settings, 5, 1);
  for (std::uint32_t invocations : {2u, 64u, 1000u}) {
    EXPECT_EQ(film_on_cpu(packed, settings, 5, invocations), film) << invocations;
  }
}

TEST(TraceJobs, any_number_of_jobs_at_a_time_gives_the_same_bits) {
  const RenderSettings settings = test::small_image(11, 9, 3);
  const PackedScene packed = test::packed_for(test::tiny_scene(), test::camera_at(3.5), settings);
  const std::vector<std::uint32_t> film = film_on_cpu(packed, settings);
  for (std::uint32_t jobs : {1u, 7u, 100u}) {
    for (std::uint32_t budget : {2u, 1u << 20}) EXPECT_EQ(film_on_cpu(packed, settings, budget, 3, jobs), film) << jobs;
  }
}

TEST(TraceJobs, costs_are_counted_whatever_the_budget) {
  COUNT_COST = true;
  const RenderSettings settings = test::small_image(8, 8, 2);
  const PackedScene packed = test::packed_for(test::tiny_scene(), test::camera_at(3.5), settings);
  const std::vector<std::uint32_t> film = film_on_cpu(packed, settings);
  EXPECT_EQ(film_on_cpu(packed, settings, 1), film);
  for (std::size_t pixel = 0; pixel < 64; ++pixel) {
    EXPECT_GE(film[pixel * FILM_WORDS + FILM_RAYS], 2u);
    EXPECT_GE(film[pixel * FILM_WORDS + FILM_NODES], film[pixel * FILM_WORDS + FILM_RAYS]);
  }
  COUNT_COST = false;
}

TEST(TraceJobs, the_effects_a_scene_asks_for_give_the_bits_of_all_of_them) {
  const RenderSettings settings = test::small_image(12, 12, 4);
  Scene scene = test::tiny_scene();
  scene.materials[2].absorption = glm::vec3(0);
  scene.lights.resize(1);
  const PackedScene packed = test::packed_for(scene, test::camera_at(3.5), settings);
  const std::vector<std::uint32_t> film = film_on_cpu(packed, settings);
  const std::uint32_t detected = detect_effects(scene, test::camera_at(3.5), 8).bits;
  EXPECT_EQ(detected & (EFFECT_ABSORPTION | EFFECT_SPOT_LIGHTS | EFFECT_DIRECTIONAL_LIGHTS), 0u);
  EFFECTS = detected;
  EXPECT_EQ(film_on_cpu(packed, settings), film);
  EFFECTS = 0xffffffffu;
}

TEST(TraceJobs, ranges_of_samples_add_up) {
  RenderSettings settings = test::small_image(8, 8, 8);
  const PackedScene packed = test::packed_for(test::tiny_scene(), test::camera_at(3.5), settings);
  const std::vector<std::uint32_t> whole = film_on_cpu(packed, settings);
  settings.sample_end = 3;
  const std::vector<std::uint32_t> first = film_on_cpu(packed, settings);
  settings.sample_begin = 3;
  settings.sample_end = 8;
  const std::vector<std::uint32_t> rest = film_on_cpu(packed, settings);
  for (std::size_t pixel = 0; pixel < 64; ++pixel) {
    const std::size_t low = pixel * FILM_WORDS + FILM_RED;
    const auto sum = [&](const std::vector<std::uint32_t>& film) {
      return static_cast<std::uint64_t>(film[low + 1]) << 32 | film[low];
    };
    ASSERT_EQ(sum(first) + sum(rest), sum(whole));
    ASSERT_EQ(first[pixel * FILM_WORDS + FILM_SAMPLES] + rest[pixel * FILM_WORDS + FILM_SAMPLES], 8u);
  }
}

TEST(TraceJobs, a_diffuse_square_by_hand) {
  // One square at z = 0 under a light along -Z of 2 lux: kd 2 / pi; under the sky 0.5 all around: ka = kd.
  Scene scene;
  Material& paint = test::add_black(scene);
  paint.base_color = glm::vec4(0.5f, 0.25f, 1.0f, 1);
  test::add_square(scene, 0.0f, 4.0f);
  scene.lights = {test::lamp(LightKind::directional, {}, {0, 0, -1}, 2.0f)};
  const std::vector<float> color = color_on_cpu(scene, test::camera_at(2), test::small_image(3, 3, 1));
  for (std::size_t pixel = 0; pixel < 9; ++pixel) {
    EXPECT_NEAR(color[4 * pixel], 0.5 * 2 / 3.14159265358979, 1e-6);
    EXPECT_NEAR(color[4 * pixel + 1], 0.25 * 2 / 3.14159265358979, 1e-6);
    EXPECT_EQ(color[4 * pixel + 3], 1.0f);
  }
}

TEST(TraceJobs, an_empty_scene_is_its_environment) {
  Scene scene;
  scene.environment.sky = scene.environment.ground = glm::vec3(0.25f, 0.5f, 2.0f);
  const std::vector<float> color = color_on_cpu(scene, test::camera_at(2), test::small_image(2, 2, 4));
  for (std::size_t pixel = 0; pixel < 4; ++pixel) {
    EXPECT_EQ(color[4 * pixel], 0.25f);
    EXPECT_EQ(color[4 * pixel + 2], 2.0f);
    EXPECT_EQ(color[4 * pixel + 3], 0.0f);
  }
}

}  // namespace
}  // namespace vernier::shader
