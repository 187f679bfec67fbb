// The trace kernel over meshes that are traced in their own space.
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "device_test.h"
#include "render/develop.h"
#include "shader/trace_on_cpu.h"
#include "traced_film.h"

namespace vernier {
namespace {

/// The tiny scene with its glass box at four places more, one of them mirrored.
Scene scene_of_copies() {
  Scene scene = test::tiny_scene();
  for (int i = 0; i < 4; ++i) {
    Instance copy = scene.instances[2];
    copy.world_from_object = glm::translate(glm::dmat4(1.0), glm::dvec3(-0.6 + 0.5 * i, 0.4 - 0.3 * i, 0.5)) *
                             glm::rotate(glm::dmat4(1.0), 0.5 * i, glm::dvec3(1, 2, 3)) *
                             glm::scale(glm::dmat4(1.0), glm::dvec3(i == 1 ? -0.3 : 0.3, 0.4, 0.2));
    scene.instances.push_back(copy);
  }
  return scene;
}

class SharedMeshKernelTest : public DeviceTest {
 protected:
  PackedScene packed(const RenderSettings& settings, Sharing sharing) const {
    PackedScene made = pack_scene(scene_, 1, BuildMethod::standard, sharing);
    set_camera(made, camera_, settings);
    set_settings(made, settings);
    return made;
  }
  std::vector<std::uint32_t> film(const RenderSettings& settings, SceneLoads loads,
                                  Sharing sharing = Sharing::always) const {
    return traced_film(device(), packed(settings, sharing), settings, loads, detect_effects(scene_, camera_, 8).bits);
  }
  std::vector<std::uint32_t> film(const RenderSettings& settings) const {
    return film(settings, choose_scene_loads(device().description()));
  }

  Scene scene_ = scene_of_copies();
  Camera camera_ = test::camera_at(3.5);
};

/// Values that differ by more than the project allows of a pixel against the reference (goldens.json, tier B).
int different(const std::vector<float>& a, const std::vector<float>& b) {
  int count = 0;
  for (std::size_t i = 0; i < a.size(); ++i) count += std::abs(a[i] - b[i]) > 1e-4f * std::max(1.0f, b[i]) ? 1 : 0;
  return count;
}

TEST_F(SharedMeshKernelTest, draws_what_the_text_draws_on_the_host_and_what_copies_draw) {
  const RenderSettings settings = test::small_image(24, 24, 2);
  const PixelRect area{0, 0, 24, 24};
  const SceneLoads loads = choose_scene_loads(device().description());
  const std::vector<float> found = develop(film(settings), area).color;
  const std::vector<float> copied = develop(film(settings, loads, Sharing::never), area).color;
  shader::INSTANCED = true;
  const std::vector<float> on_host =
      develop(shader::film_on_cpu(packed(settings, Sharing::always), settings), area).color;
  shader::INSTANCED = false;
  // Where rounding decides about another triangle or texel a pixel may differ wholly.
  EXPECT_LE(different(found, on_host), static_cast<int>(found.size()) / 100);
  EXPECT_LE(different(found, copied), static_cast<int>(found.size()) / 50);
}

TEST_F(SharedMeshKernelTest, ways_to_make_the_picture_change_no_bit) {
  const RenderSettings settings = test::small_image(40, 24, 2);
  const std::vector<std::uint32_t> expected = film(settings);
  EXPECT_EQ(film(settings, SceneLoads::texels), expected);
  EXPECT_EQ(film(settings, SceneLoads::storage), expected);
  RenderSettings other = settings;
  other.tile = glm::ivec2(8, 8);
  other.dispatch_ms = 0.001;
  EXPECT_EQ(film(other), expected);
  other = settings;
  other.crop = PixelRect{11, 7, 19, 10};
  const std::vector<std::uint32_t> part = film(other);
  ASSERT_EQ(part.size(), std::size_t{19 * 10 * FILM_WORDS});
  for (std::size_t y = 0; y < 10; ++y) {
    const auto row = expected.begin() + static_cast<std::ptrdiff_t>(((y + 7) * 40 + 11) * FILM_WORDS);
    ASSERT_TRUE(
        std::equal(row, row + 19 * FILM_WORDS, part.begin() + static_cast<std::ptrdiff_t>(y * 19 * FILM_WORDS)));
  }
}

}  // namespace
}  // namespace vernier
