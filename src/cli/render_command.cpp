#include "cli/render_command.h"

#include <cstdio>
#include <memory>

#include "cli/commands.h"
#include "cli/cost_legend.h"
#include "cli/exposure_hint.h"
#include "cli/interrupt.h"
#include "cli/output_file.h"
#include "cli/parse_values.h"
#include "cli/progress_bar.h"
#include "cli/recipe.h"
#include "cli/render_report.h"
#include "cli/sample_command.h"
#include "cli/scene_setup.h"
#include "cli/warnings.h"
#include "error.h"
#include "image/whole_file.h"
#include "image/write_image.h"
#include "render/pipeline_file.h"
#include "render/render_image.h"

namespace vernier {
namespace {

RenderResult render_with_progress(const Device& device, const SceneSetup& setup, const RenderPlan& plan) {
  ProgressBar bar(plan.quiet);
  RenderCallbacks callbacks;
  callbacks.progress = [&bar](const RenderProgress& progress) {
    bar.update({progress.share, progress.rays_per_s, progress.eta_s});
  };
  callbacks.cancelled = interrupted;
  return render_image(device, setup.scene, setup.camera, plan.settings, callbacks);
}

void print_summary(const RenderPlan& plan, const RenderReport& report, const ImageFile& image) {
  if (plan.quiet) {
    return;
  }
  if (plan.verbose) {
    std::fputs(verbose_text(report).c_str(), stderr);
  }
  std::fprintf(stderr, "%s\n", summary_line(report, plan.output).c_str());
  const std::string legend = cost_legend(image);
  if (!legend.empty()) std::fprintf(stderr, "%s\n", legend.c_str());
  const std::string hint = exposure_hint(image, plan.display.exposure_ev);
  if (!hint.empty()) {
    std::fprintf(stderr, "%s\n", hint.c_str());
  }
}

// What makes a render that was written a failed one.
void check_outcome(const RenderReport& report, const RenderPlan& plan) {
  const RenderStatistics& statistics = report.statistics;
  if (statistics.non_finite_pixels > 0) {
    throw Error(ErrorKind::failed, plan.output + ": " + non_finite_text(statistics) + "; again by: " +
                                       sample_command(plan, report.device.name, statistics.first_non_finite));
  }
  if (interrupted()) {
    throw Error(ErrorKind::failed, plan.output + ": interrupted; it holds what was done by then");
  }
}

int run_render(const RenderPlan& plan) {
  catch_interrupt();
  const double aspect = static_cast<double>(plan.settings.width) / plan.settings.height;
  const SceneSetup setup = set_up_scene(plan.scene, aspect);
  print_warnings(setup.scene.warnings);
  const VulkanInstance instance;
  const DeviceDescription description = choose_device(list_devices(instance), plan.device);
  const CachedDevice device(instance, description, pipeline_file(description.pipeline_key));
  RenderResult result = render_with_progress(device.device(), setup, plan);
  print_warnings(result.statistics.warnings);

  RenderReport report{setup.scene.source, description,          plan.settings, std::move(result.statistics),
                      setup.load_ms,      setup.scene.warnings, device.store()};
  report.warnings.insert(report.warnings.end(), report.statistics.warnings.begin(), report.statistics.warnings.end());
  const RecipeMaker maker{description.name, description.driver, report.statistics.spirv_hash};
  result.image.metadata.merge(render_recipe(plan.scene_arguments, setup.scene.files, plan.render_arguments, maker));
  if (report.statistics.error) {
    result.image.metadata["vernier:error_estimate"] = error_text(*report.statistics.error);
  }
  const std::string legend = cost_legend(result.image);
  if (!legend.empty()) result.image.metadata["vernier:cost_legend"] = legend;
  write_image(plan.output, result.image, plan.display);
  if (!plan.json_file.empty()) {
    write_text(plan.json_file, render_json(report).dump(2) + "\n");
  }
  print_summary(plan, report, result.image);
  check_outcome(report, plan);
  return 0;
}

}  // namespace

RenderPlan plan_render(const RenderCommandArguments& arguments) {
  RenderPlan plan;
  plan.scene_arguments = arguments.scene;
  plan.render_arguments = arguments.render;
  plan.scene = parse_scene_settings(arguments.scene);
  plan.settings = parse_render_settings(arguments.render);
  plan.display.exposure_ev = parse_exposure(arguments.exposure);
  plan.device = arguments.device;
  plan.output = arguments.output.empty() ? default_image_path(arguments.scene.scene) : arguments.output;
  plan.json_file = arguments.json_file;
  plan.quiet = arguments.quiet;
  plan.verbose = arguments.verbose;
  check_image_output(plan.output);
  check_text_output(plan.json_file);
  return plan;
}

void add_render_command(CLI::App& app, Command& chosen) {
  const auto arguments = std::make_shared<RenderCommandArguments>();
  CLI::App& command =
      *app.add_subcommand("render", "Renders one image; without SCENE the built-in scene that shows every effect.");
  command.add_option("SCENE", arguments->scene.scene, "scene file: .gltf, .glb or .obj (default: the built-in scene)")
      ->type_name("");
  command
      .add_option(
          "-o,--output", arguments->output,
          "image file: .exr (linear, all layers), .png, .jpg, .hdr or .tif (default: NAME.png of the scene here, else "
          "vernier.png)")
      ->type_name("FILE");
  add_render_options(command, arguments->render);
  add_scene_options(command, arguments->scene);
  command
      .add_option("--device", arguments->device, "index or part of the name, see vernier devices (default: the best)")
      ->type_name("INDEX|NAME");
  command
      .add_option("--exposure", arguments->exposure,
                  "stops added to display images, -100 to 100; EXR stays linear (default: 0)")
      ->type_name("EV");
  command.add_option("--json", arguments->json_file, "writes statistics (default: none)")->type_name("FILE");
  CLI::Option* quiet =
      command.add_flag("--quiet", arguments->quiet, "no progress and no summary; warnings stay (default: off)");
  command
      .add_flag("--verbose", arguments->verbose,
                "adds device, effects with reasons and times to the summary (default: off)")
      ->excludes(quiet);
  command.footer(
      "Example: vernier render scenes/every_effect.glb -o picture.exr --size 640x360 --spp 64 --aov depth,normal\n"
      "Ctrl-C writes what is done and ends with exit code 1; a second Ctrl-C ends at once.");
  command.callback([arguments, &chosen] { chosen = [arguments] { return run_render(plan_render(*arguments)); }; });
}

}  // namespace vernier
