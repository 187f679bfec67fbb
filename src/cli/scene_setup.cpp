#include "cli/scene_setup.h"

#include <chrono>
#include <utility>

#include "cli/builtin_scene.h"
#include "cli/choose_camera.h"
#include "math/elapsed.h"
#include "render/memory_need.h"
#include "scene/environment_image.h"
#include "scene/frame_scene.h"
#include "scene/load_scene.h"

namespace vernier {
namespace {

using Clock = std::chrono::steady_clock;

LoadingScene open_input(const SceneSettings& settings) {
  const LoadOptions options{settings.strict};
  return settings.scene.empty() ? open_builtin_scene(options) : open_scene(settings.scene, options);
}

bool sets_background(const SceneSettings& settings) {
  return settings.background_color.has_value() || !settings.background_file.empty();
}

void set_background(Scene& scene, PendingImages& images, const SceneSettings& settings) {
  if (settings.background_color) {
    scene.environment = Environment{};
    scene.environment.sky = scene.environment.ground = *settings.background_color;
  } else if (!settings.background_file.empty()) {
    scene.environment = Environment{};
    scene.environment.texture = add_environment_image(scene, images, settings.background_file);
  }
}

}  // namespace

void set_lighting(Scene& scene, PendingImages& images, const Camera& camera, const SceneSettings& settings) {
  if (!settings.lights.empty()) {
    scene.lights = settings.lights;
  }
  set_background(scene, images, settings);
  const Environment before = scene.environment;
  add_default_lighting(scene, camera);
  // Black is a background too, if asked for.
  if (sets_background(settings)) {
    scene.environment = before;
  }
  if (settings.ambient) {
    scene.environment.has_ambient_override = true;
    scene.environment.ambient = *settings.ambient;
  }
}

LoadingSetup open_setup(const SceneSettings& settings, double aspect) {
  const Clock::time_point start = Clock::now();
  LoadingScene input = open_input(settings);
  LoadingSetup loading{{}, std::move(input.images)};
  SceneSetup& setup = loading.setup;
  setup.scene = std::move(input.scene);
  setup.camera = choose_camera(setup.scene, settings, aspect);
  setup.default_lights = setup.scene.lights.empty() && settings.lights.empty();
  set_lighting(setup.scene, loading.images, setup.camera, settings);
  setup.load_ms = ms_since(start);
  return loading;
}

SceneSetup finish(LoadingSetup loading) {
  const Clock::time_point start = Clock::now();
  loading.images.finish(loading.setup.scene);
  loading.setup.load_ms += ms_since(start);
  return std::move(loading.setup);
}

SceneSetup set_up_scene(const SceneSettings& settings, double aspect) {
  SceneSetup setup = finish(open_setup(settings, aspect));
  check_memory(setup.scene.source, memory_need(setup.scene), memory_there());
  return setup;
}

}  // namespace vernier
