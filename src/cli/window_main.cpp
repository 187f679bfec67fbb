// The program with the window, which `vernier view` becomes.
#include <CLI/CLI.hpp>
#include <chrono>
#include <fstream>
#include <sstream>
#include <utility>

#include "cli/camera_arguments.h"
#include "cli/choose_camera.h"
#include "cli/interrupt.h"
#include "cli/run_command_line.h"
#include "cli/save_picture.h"
#include "cli/scene_setup.h"
#include "cli/view_options.h"
#include "cli/warnings.h"
#include "error.h"
#include "gpu/vector_width.h"
#include "math/elapsed.h"
#include "preview/picture_limit.h"
#include "preview/viewer.h"
#include "render/memory_need.h"
#include "render/pack_scene.h"

namespace vernier {
namespace {

/// `settings` with the camera that `words` say.
SceneSettings with_words(const SceneSettings& settings, const RenderCommandArguments& arguments,
                         const CameraWords& words) {
  SceneSettings changed = parse_scene_settings(with_camera(arguments.scene, words));
  changed.scene = settings.scene;
  return changed;
}

/// Builds the tree while images are decoded.
PackedScene pack_viewed(LoadingSetup& loading, BuildMethod method) {
  const Scene& scene = loading.setup.scene;
  const MemoryNeed need = memory_need(scene);
  MemoryClaim claim;
  check_memory(scene.source, need, claim_memory(claim, need, memory_there()));
  return pack_shape(scene, 0, method, [&](double) { loading.images.check_so_far(); });
}

ViewedScene load_viewed(SceneSettings settings, const RenderCommandArguments& arguments, const CameraWords& words,
                        BuildMethod method, double aspect) {
  const auto start = std::chrono::steady_clock::now();
  settings = with_words(settings, arguments, words);
  LoadingSetup loading = open_setup(settings, aspect);
  ViewedScene viewed;
  viewed.source = settings.scene;
  viewed.packed = pack_viewed(loading, method);
  SceneSetup setup = finish(std::move(loading));
  print_warnings(setup.scene.warnings);
  check_memory(setup.scene.source, after_shape(memory_need(setup.scene)), memory_there());
  pack_look(setup.scene, viewed.packed);
  viewed.words = words;
  viewed.camera = setup.camera;
  viewed.lights_follow = setup.default_lights;
  viewed.scene = std::move(setup.scene);
  viewed.load_ms = ms_since(start);
  return viewed;
}

std::vector<ScriptEvent> read_script(const std::string& path) {
  if (path.empty()) return {};
  std::ifstream file(path);
  std::ostringstream text;
  if (!(text << file.rdbuf())) throw Error(ErrorKind::refused, path + ": cannot be read, or is empty");
  return parse_script(path, text.str());
}

void view(const ViewArguments& arguments) {
  const ViewSettings settings = parse_view(arguments);
  const std::string fault = picture_fault({settings.render.width, settings.render.height});
  if (!fault.empty()) throw Error(ErrorKind::usage, "--size: " + fault);
  const RenderCommandArguments& render = arguments.render;
  catch_interrupt();
  ViewPlan plan;
  plan.source = render.scene.scene;
  plan.settings = settings.render;
  plan.words = words_of(render.scene);
  plan.device = render.device;
  plan.exposure_ev = settings.exposure_ev;
  plan.interrupted = interrupted;
  plan.script = read_script(arguments.script);
  plan.record_folder = arguments.record;
  plan.places_file = arguments.places;
  plan.load_scene = [&](const std::string& source, const CameraWords& words, double aspect) {
    SceneSettings of_source = settings.scene;
    of_source.scene = source;
    return load_viewed(of_source, render, words, settings.render.bvh, aspect);
  };
  plan.camera_of = [&](const Scene& scene, const CameraWords& words, double aspect) {
    return choose_camera(scene, with_words(settings.scene, render, words), aspect);
  };
  plan.save = [&](const SavedPicture& picture) { save_picture(render, picture); };
  view_scene(plan);
}

}  // namespace
}  // namespace vernier

int main(int argc, char** argv) {
  using namespace vernier;
  keep_vectors_narrow();
  CLI::App app("The window of vernier view.", "vernier");
  app.require_subcommand(1);
  ViewArguments arguments;
  add_view_subcommand(app, arguments);
  return run_command_line(
      app,
      [&] {
        view(arguments);
        return 0;
      },
      argc, argv);
}
