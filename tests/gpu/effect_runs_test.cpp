// The counters of how often each effect ran: nothing that is off runs, and what is on runs somewhere.
#include <bit>

#include "device_test.h"
#include "every_effect.h"
#include "render/render_image.h"
#include "scene/load_scene.h"
#include "shader/tiny_scene.h"

namespace vernier {
namespace {

class EffectRunsTest : public DeviceTest {
 protected:
  RenderResult rendered(const Scene& scene, const Camera& camera, const RenderSettings& settings) const {
    return render_image(device(), scene, camera, settings, {});
  }

  RenderStatistics counted(const Scene& scene, const Camera& camera, RenderSettings settings) const {
    settings.count_effects = true;
    return rendered(scene, camera, settings).statistics;
  }

  RenderSettings settings_ = test::small_image(48, 48, 2);
  Scene scene_ = test::tiny_scene();
  Camera camera_ = test::camera_at(3.5);
};

std::uint64_t runs_of(const RenderStatistics& statistics, std::uint32_t effect) {
  return statistics.effect_runs.searches.at(static_cast<std::size_t>(std::countr_zero(effect)));
}

/// What is off ran in no search, and what is on in some.
void expect_runs_as_chosen(const RenderStatistics& statistics) {
  for (const EffectReason& effect : statistics.effects.reasons) {
    const std::uint64_t runs = runs_of(statistics, effect.bit);
    EXPECT_EQ(runs > 0, effect.on) << effect.name << ": " << runs << " searches; " << effect.reason;
  }
}

/// A floor seen from above under one lamp, and nothing else.
Scene plain_scene() {
  Scene scene;
  Material& matte = test::add_black(scene);
  matte.base_color = glm::vec4(0.5f, 0.5f, 0.5f, 1);
  test::add_square(scene, -1.0f, 1.5f);
  scene.lights = {test::lamp(LightKind::directional, {}, glm::normalize(glm::dvec3(-0.3, -0.5, -1)), 0.7f)};
  return scene;
}

TEST_F(EffectRunsTest, without_the_counters_nothing_is_counted) {
  const RenderStatistics statistics = rendered(scene_, camera_, settings_).statistics;
  EXPECT_TRUE(statistics.effect_runs.searches.empty());
  EXPECT_TRUE(statistics.effect_runs.by_depth.empty());
}

TEST_F(EffectRunsTest, what_is_off_never_runs_and_what_is_on_does) {
  expect_runs_as_chosen(counted(scene_, camera_, settings_));
  expect_runs_as_chosen(counted(plain_scene(), camera_, settings_));
  expect_runs_as_chosen(counted(test::every_effect_scene(), test::orthographic_camera(), settings_));
}

TEST_F(EffectRunsTest, each_effect_that_is_switched_off_stops_running) {
  const std::uint32_t effects = EFFECT_SHADOWS | EFFECT_REFRACTION | EFFECT_SMOOTH_NORMALS | EFFECT_ALPHA_BLEND;
  RenderSettings without = settings_;
  without.effects = "auto,-shadows,-refraction,-smooth_normals,-alpha_blend,-alpha_mask";
  const RenderStatistics statistics = counted(scene_, camera_, without);
  for (std::uint32_t left = effects; left != 0; left &= left - 1) EXPECT_EQ(runs_of(statistics, left & -left), 0u);
  EXPECT_GT(runs_of(statistics, EFFECT_REFLECTION), 0u) << "the others go on";
}

TEST_F(EffectRunsTest, an_effect_that_is_on_for_nothing_runs_without_a_reason) {
  // Detection finds these off. Were it wrong to leave them on, or were the counters dead, this would show.
  RenderSettings superset = settings_;
  superset.effects = "all";
  const RenderStatistics plain = counted(plain_scene(), camera_, settings_);
  const RenderStatistics forced = counted(plain_scene(), camera_, superset);
  for (const std::uint32_t effect : {EFFECT_REFLECTION, EFFECT_SPECULAR, EFFECT_AMBIENT}) {
    EXPECT_EQ(runs_of(plain, effect), 0u);
    EXPECT_GT(runs_of(forced, effect), 0u);
  }
}

TEST_F(EffectRunsTest, counting_changes_no_bit) {
  RenderSettings counting = settings_;
  counting.count_effects = true;
  const Layer plain = rendered(scene_, camera_, settings_).image.layers.front();
  EXPECT_EQ(rendered(scene_, camera_, counting).image.layers.front().values, plain.values);
}

TEST_F(EffectRunsTest, rays_by_depth_add_up_to_the_rays) {
  const RenderStatistics statistics = counted(scene_, camera_, settings_);
  DepthRays sum;
  for (const DepthRays& rays : statistics.effect_runs.by_depth) {
    sum.path += rays.path;
    sum.shadow += rays.shadow;
  }
  EXPECT_EQ(sum.path, statistics.rays.primary + statistics.rays.reflection + statistics.rays.refraction);
  EXPECT_EQ(sum.shadow, statistics.rays.shadow);
  EXPECT_EQ(statistics.effect_runs.by_depth[0].path, statistics.rays.primary);
  EXPECT_GT(statistics.effect_runs.by_depth[2].path, 0u) << "into the glass and out of it";
  for (std::size_t depth = settings_.max_bounces + 1; depth < statistics.effect_runs.by_depth.size(); ++depth) {
    EXPECT_EQ(statistics.effect_runs.by_depth[depth].path, 0u) << depth;
  }
}

TEST_F(EffectRunsTest, counts_are_the_same_however_the_work_is_cut_up) {
  const RenderStatistics whole = counted(scene_, camera_, settings_);
  RenderSettings cut = settings_;
  cut.dispatch_ms = 1e-3;
  cut.tile = glm::ivec2(16, 24);
  const RenderStatistics parts = counted(scene_, camera_, cut);
  EXPECT_EQ(parts.effect_runs.searches, whole.effect_runs.searches);
  EXPECT_EQ(parts.effect_runs.by_depth[1].path, whole.effect_runs.by_depth[1].path);
  EXPECT_EQ(parts.effect_runs.by_depth[0].shadow, whole.effect_runs.by_depth[0].shadow);
}

TEST_F(EffectRunsTest, a_scene_without_branches_has_no_path_stack) {
  const RenderStatistics lean = rendered(plain_scene(), camera_, settings_).statistics;
  RenderSettings superset = settings_;
  superset.effects = "all";
  superset.aovs = {"depth", "cost"};
  const RenderStatistics full = rendered(plain_scene(), camera_, superset).statistics;
  EXPECT_EQ(full.saved.path_stack_bytes, 0u);
  EXPECT_EQ(full.saved.sample_cost_bytes, 0u);
  EXPECT_EQ(full.saved.aov_bytes, 0u);
  EXPECT_GT(lean.saved.path_stack_bytes, 0u);
  constexpr std::uint64_t kEmptyBuffer_bytes = 16;  // what a Buffer of no bytes is rounded up to: the AOVs left out
  EXPECT_EQ(full.device_bytes - lean.device_bytes + kEmptyBuffer_bytes,
            lean.saved.path_stack_bytes + lean.saved.sample_cost_bytes + lean.saved.aov_bytes)
      << "what is said to be saved is what the allocations differ by";
}

}  // namespace
}  // namespace vernier
