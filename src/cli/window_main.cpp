// The program with the window, which `vernier view` becomes.
#include <cstdio>
#include <exception>

#include "cli/interrupt.h"
#include "cli/scene_setup.h"
#include "cli/view_options.h"
#include "error.h"
#include "preview/viewer.h"

namespace vernier {
namespace {

void view(const ViewArguments& arguments) {
  const ViewSettings settings = parse_view(arguments);
  catch_interrupt();
  ViewPlan plan;
  plan.source = arguments.scene.scene;
  plan.settings = settings.render;
  plan.device = settings.device;
  plan.exposure_ev = settings.exposure_ev;
  plan.interrupted = interrupted;
  plan.load_scene = [&settings](const std::string& source, double aspect) {
    SceneSettings of_source = settings.scene;
    of_source.scene = source;
    SceneSetup setup = set_up_scene(of_source, aspect);
    return ViewedScene{std::move(setup.scene), std::move(setup.camera)};
  };
  view_scene(plan);
}

}  // namespace
}  // namespace vernier

int main(int argc, char** argv) {
  using namespace vernier;
  try {
    CLI::App app("The window of vernier view.", "vernier");
    ViewArguments arguments;
    add_view_subcommand(app, arguments);
    CLI11_PARSE(app, argc, argv);
    view(arguments);
    return 0;
  } catch (const Error& error) {
    std::fprintf(stderr, "error: %s\n", error.what());
    return static_cast<int>(error.kind());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "error: %s\n", error.what());
    return static_cast<int>(ErrorKind::failed);
  }
}
