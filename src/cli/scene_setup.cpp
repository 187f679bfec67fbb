#include "cli/scene_setup.h"

#include <chrono>

#include "cli/builtin_scene.h"
#include "cli/choose_camera.h"
#include "render/memory_need.h"
#include "scene/environment_image.h"
#include "scene/frame_scene.h"
#include "scene/load_scene.h"

namespace vernier {
namespace {

Scene load_input(const SceneSettings& settings) {
  const LoadOptions options{settings.strict};
  return settings.scene.empty() ? load_builtin_scene(options) : load_scene(settings.scene, options);
}

bool sets_background(const SceneSettings& settings) {
  return settings.background_color.has_value() || !settings.background_file.empty();
}

void set_background(Scene& scene, const SceneSettings& settings) {
  if (settings.background_color) {
    scene.environment = Environment{};
    scene.environment.sky = scene.environment.ground = *settings.background_color;
  } else if (!settings.background_file.empty()) {
    scene.environment = Environment{};
    scene.environment.texture = add_environment_image(scene, settings.background_file);
  }
}

}  // namespace

void set_lighting(Scene& scene, const Camera& camera, const SceneSettings& settings) {
  if (!settings.lights.empty()) {
    scene.lights = settings.lights;
  }
  set_background(scene, settings);
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

SceneSetup set_up_scene(const SceneSettings& settings, double aspect) {
  const auto start = std::chrono::steady_clock::now();
  SceneSetup setup;
  setup.scene = load_input(settings);
  check_memory(setup.scene.source, memory_need(setup.scene), memory_there());
  setup.camera = choose_camera(setup.scene, settings, aspect);
  setup.default_lights = setup.scene.lights.empty() && settings.lights.empty();
  set_lighting(setup.scene, setup.camera, settings);
  setup.load_ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  return setup;
}

}  // namespace vernier
