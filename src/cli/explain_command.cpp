#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <memory>
#include <optional>

#include "cli/commands.h"
#include "cli/effect_table.h"
#include "cli/interrupt.h"
#include "cli/json_text.h"
#include "cli/ledger_table.h"
#include "cli/output_file.h"
#include "cli/progress_bar.h"
#include "cli/render_options.h"
#include "cli/scene_setup.h"
#include "cli/warnings.h"
#include "effects/choose_effects.h"
#include "error.h"
#include "math/elapsed.h"
#include "render/form_file.h"
#include "render/pipeline_file.h"

namespace vernier {
namespace {

struct ExplainArguments {
  SceneArguments scene;
  RenderArguments render;
  std::string device;
  std::string json_file;
  bool with_costs = true;
  bool quiet = false;
};

/// Small, since every effect that is on is traced a dozen times.
ExplainArguments default_arguments() {
  ExplainArguments arguments;
  arguments.render.size = "192x108";
  arguments.render.spp = "4";
  return arguments;
}

Explanation planned(const SceneSetup& setup, const RenderSettings& settings) {
  Explanation explanation;
  explanation.scene = setup.scene.source;
  explanation.settings = settings;
  const auto start = std::chrono::steady_clock::now();
  explanation.plan = plan_effects(setup.scene, setup.camera, settings.max_bounces, settings.cutoff, settings.effects);
  explanation.plan_ms = ms_since(start);
  return explanation;
}

void measure(const SceneSetup& setup, const ExplainArguments& arguments, Explanation& explanation) {
  const VulkanInstance instance;
  const DeviceDescription description = choose_device(list_devices(instance), arguments.device);
  const CachedDevice device(instance, description, pipeline_file(description.pipeline_key));
  explanation.settings.traversal = calibrated_form(description, setup.scene, explanation.settings.traversal);
  ProgressBar bar(arguments.quiet);
  const WorkClock clock;
  EffectCostSetup bench;
  bench.progress = [&](double share) { bar.update(clock.at(share)); };
  bench.stop = interrupted;
  explanation.ledger =
      measure_effect_costs(device.device(), setup.scene, setup.camera, explanation.settings, explanation.plan, bench);
  explanation.device = description.name;
  explanation.driver = description.driver;
  device.store();
}

/// Measures what the arguments ask for. What stands in the way, if it is the device: on, off and why need none.
std::optional<Error> measure_if_possible(const SceneSetup& setup, const ExplainArguments& arguments,
                                         Explanation& explanation) {
  if (!arguments.with_costs) return std::nullopt;
  try {
    measure(setup, arguments, explanation);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::no_device) throw;
    return Error(error.kind(), std::string("costs need a device (--no-costs needs none): ") + error.what());
  }
  if (explanation.ledger.complete) return std::nullopt;
  return Error(ErrorKind::failed, "interrupted; effects without figures were not measured");
}

int run_explain(const ExplainArguments& arguments) {
  catch_interrupt();
  const RenderSettings settings = parse_render_settings(arguments.render);
  const SceneSettings scene_settings = parse_scene_settings(arguments.scene);
  check_json_output(arguments.json_file);
  const std::vector<NamedFile> files = {{"SCENE", scene_settings.scene, true},
                                        {"--background", scene_settings.background_file, true},
                                        {"--json", arguments.json_file}};
  check_distinct(files);
  const double aspect = aspect_of(settings);
  const SceneSetup setup = set_up_scene(scene_settings, aspect);
  check_not_read(files, setup.scene.files);
  print_warnings(setup.scene.warnings);
  Explanation explanation = planned(setup, settings);
  const std::optional<Error> missing = measure_if_possible(setup, arguments, explanation);
  write_json(arguments.json_file, json_text(explain_json(explanation)));
  const bool measured = !explanation.device.empty();
  print_result(arguments.json_file, measured ? ledger_table(explanation) : effect_table(explanation.plan));
  if (missing) throw *missing;
  return 0;
}

}  // namespace

void add_explain_command(CLI::App& app, Command& chosen) {
  const auto arguments = std::make_shared<ExplainArguments>(default_arguments());
  CLI::App& command = *app.add_subcommand(
      "explain",
      "The effects a scene calls for: on or off, why, what each costs, and what the image loses without it. Costs are "
      "measured by leaving one effect out at a time, traced in turn with the whole frame. Without a device on, off and "
      "why are told all the same, with exit code 4.");
  add_scene_argument(command, arguments->scene.scene, true);
  add_size_option(command, arguments->render.size);
  command.add_option("--spp", arguments->render.spp, "samples per pixel; 1 samples the pixel centre (default: 4)")
      ->type_name("N");
  add_path_options(command, arguments->render);
  add_accuracy_option(command, arguments->render.accuracy);
  add_effects_option(command, arguments->render.effects);
  add_filter_options(command, arguments->render);
  add_bvh_option(command, arguments->render.bvh);
  add_dispatch_options(command, arguments->render);
  add_traversal_option(command, arguments->render.traversal);
  add_scene_options(command, arguments->scene);
  add_device_option(command, arguments->device);
  command.add_flag("--costs,!--no-costs", arguments->with_costs, "measures what each effect costs (default: on)");
  command.add_option("--json", arguments->json_file, "writes the same as JSON (default: none)")->type_name("FILE");
  command.add_flag("--quiet", arguments->quiet, "no progress; warnings stay (default: off)");
  command.footer("Example: vernier explain scenes/every_effect.glb --max-bounces 0");
  command.callback([arguments, &chosen] { chosen = [arguments] { return run_explain(*arguments); }; });
}

}  // namespace vernier
