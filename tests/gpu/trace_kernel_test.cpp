// The whole trace kernel: against its text run as C++, and against itself cut up in other ways.
#include <cmath>

#include "device_test.h"
#include "render/develop.h"
#include "shader/trace_on_cpu.h"
#include "traced_film.h"

namespace vernier {
namespace {

class TraceKernelTest : public DeviceTest {
 protected:
  std::vector<std::uint32_t> film(const RenderSettings& settings, std::uint32_t effects, SceneLoads loads) const {
    return traced_film(device(), test::packed_for(scene_, camera_, settings), settings, loads, effects);
  }
  std::vector<std::uint32_t> film(const RenderSettings& settings) const {
    return film(settings, detect_effects(scene_, camera_, 8).bits, choose_scene_loads(device().description()));
  }

  Scene scene_ = test::tiny_scene();
  Camera camera_ = test::camera_at(3.5);
};

TEST_F(TraceKernelTest, the_device_draws_what_the_same_text_draws_on_the_host) {
  const RenderSettings settings = test::small_image(24, 24, 2);
  const PixelRect area{0, 0, 24, 24};
  const std::vector<float> found = develop(film(settings), area).color;
  const std::vector<float> expected =
      develop(shader::film_on_cpu(test::packed_for(scene_, camera_, settings), settings), area).color;
  // Intersections are the same bits; shading may differ in its last bits, and where such a bit decides about another
  // triangle or texel a pixel may differ wholly.
  int different = 0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    different += std::abs(found[i] - expected[i]) > 1e-5f * std::max(1.0f, expected[i]) ? 1 : 0;
  }
  EXPECT_LE(different, static_cast<int>(found.size()) / 100);
}

TEST_F(TraceKernelTest, effects_that_nothing_asks_for_change_no_bit) {
  scene_.materials[2].absorption = glm::vec3(0);
  scene_.materials[1].metallic = 0.0f;
  scene_.lights.resize(1);
  const RenderSettings settings = test::small_image(24, 24, 2);
  const SceneLoads loads = choose_scene_loads(device().description());
  const std::uint32_t detected = detect_effects(scene_, camera_, 8).bits;
  ASSERT_NE(detected, 0xffffffffu);
  EXPECT_EQ(film(settings, detected, loads), film(settings, 0xffffffffu, loads));
}

TEST_F(TraceKernelTest, kernels_for_one_workflow_have_the_bits_of_those_for_all) {
  const RenderSettings settings = test::small_image(24, 24, 2);
  const SceneLoads loads = choose_scene_loads(device().description());
  for (const Workflow workflow : {Workflow::metallic_roughness, Workflow::specular_glossiness, Workflow::blinn}) {
    for (Material& material : scene_.materials) {
      material.workflow = workflow;
      material.exponent = 40.0f;
    }
    const PackedScene packed = test::packed_for(scene_, camera_, settings);
    ASSERT_EQ(packed.workflows, 1u << static_cast<std::uint32_t>(workflow));
    const std::uint32_t effects = detect_effects(scene_, camera_, 8).bits;
    EXPECT_EQ(traced_film(device(), packed, settings, loads, effects),
              traced_film(device(), packed, settings, loads, effects, ALL_WORKFLOWS))
        << "workflow " << static_cast<int>(workflow);
  }
}

TEST_F(TraceKernelTest, texel_and_storage_loads_give_the_same_bits) {
  const RenderSettings settings = test::small_image(32, 32, 4);
  const std::uint32_t detected = detect_effects(scene_, camera_, 8).bits;
  EXPECT_EQ(film(settings, detected, SceneLoads::texels), film(settings, detected, SceneLoads::storage));
}

TEST_F(TraceKernelTest, a_shifted_stack_and_an_array_give_the_same_bits) {
  const RenderSettings settings = test::small_image(32, 32, 4);
  const PackedScene packed = test::packed_for(scene_, camera_, settings);
  const std::uint32_t effects = detect_effects(scene_, camera_, 8).bits;
  const auto film_of = [&](TraversalForm form) {
    return traced_film(device(), packed, settings, SceneLoads::storage, effects, {}, form);
  };
  EXPECT_EQ(film_of(TraversalForm::storage_shifted), film_of(TraversalForm::storage_array));
}

TEST_F(TraceKernelTest, tiles_dispatch_times_and_repetition_change_no_bit) {
  const RenderSettings settings = test::small_image(40, 24, 2);
  const std::vector<std::uint32_t> expected = film(settings);
  EXPECT_EQ(film(settings), expected) << "second run";
  RenderSettings other = settings;
  for (const glm::ivec2& tile : {glm::ivec2(8, 8), glm::ivec2(64, 64), glm::ivec2(40, 24), glm::ivec2(13, 5)}) {
    other.tile = tile;
    EXPECT_EQ(film(other), expected) << tile.x;
  }
  other.tile = glm::ivec2(0);
  for (double dispatch_ms : {0.001, 5.0, 500.0}) {
    other.dispatch_ms = dispatch_ms;
    EXPECT_EQ(film(other), expected) << dispatch_ms;
  }
}

TEST_F(TraceKernelTest, a_crop_has_the_bits_of_the_whole) {
  RenderSettings settings = test::small_image(40, 24, 2);
  const std::vector<std::uint32_t> whole = film(settings);
  settings.crop = PixelRect{11, 7, 19, 10};
  const std::vector<std::uint32_t> part = film(settings);
  ASSERT_EQ(part.size(), std::size_t{19 * 10 * FILM_WORDS});
  for (std::size_t y = 0; y < 10; ++y) {
    const auto row = whole.begin() + static_cast<std::ptrdiff_t>(((y + 7) * 40 + 11) * FILM_WORDS);
    ASSERT_TRUE(
        std::equal(row, row + 19 * FILM_WORDS, part.begin() + static_cast<std::ptrdiff_t>(y * 19 * FILM_WORDS)));
  }
}

TEST_F(TraceKernelTest, a_dispatch_beyond_the_driver_s_loop_limit_loses_nothing) {
  // A ray meets 60 squares in one place: over a hundred steps each, of which llvmpipe allows an invocation 65535 in
  // all. Dispatches of one search per invocation stay below; both must sum up to the same bits.
  for (int i = 0; i < 60; ++i) test::add_square(scene_, 0.2f, 3.0f);
  RenderSettings settings = test::small_image(64, 64, 2);
  settings.dispatch_ms = 1e6;
  const std::vector<std::uint32_t> at_once = film(settings);
  settings.dispatch_ms = 1e-6;
  EXPECT_EQ(film(settings), at_once);
  for (std::size_t pixel = 0; pixel < 64 * 64; ++pixel) ASSERT_EQ(at_once[pixel * FILM_WORDS + FILM_SAMPLES], 2u);
}

}  // namespace
}  // namespace vernier
