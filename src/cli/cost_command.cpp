#include <spawn.h>
#include <sys/wait.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>

#include "accuracy/cost_json.h"
#include "accuracy/sweep.h"
#include "cli/commands.h"
#include "cli/diff_report.h"
#include "cli/interrupt.h"
#include "cli/json_text.h"
#include "cli/output_file.h"
#include "cli/parse_values.h"
#include "cli/point_command.h"
#include "cli/progress_bar.h"
#include "cli/scene_setup.h"
#include "cli/warnings.h"
#include "error.h"
#include "image/codec_module.h"
#include "image/color_image.h"
#include "image/read_image.h"
#include "image/whole_file.h"
#include "image/write_image.h"
#include "render/form_file.h"
#include "render/pipeline_file.h"

extern char** environ;  // POSIX declares it nowhere

namespace vernier {
namespace {

namespace fs = std::filesystem;

constexpr double kQuickBudget_s = 45.0;  // with loading and writing below a minute
constexpr double kLeastBudget_s = 5.0;
constexpr double kMostBudget_s = 86400.0;

struct CostArguments {
  SceneArguments scene;
  RenderArguments render;
  std::string folder;
  std::string budget;
  std::string reference;
  std::string device;
  bool quick = false;
  bool quiet = false;
};

/// Small, since every point is rendered several times.
CostArguments default_arguments() {
  CostArguments arguments;
  arguments.render.size = "";
  arguments.render.spp = "16";
  return arguments;
}

SweepSetup sweep_setup(const CostArguments& arguments) {
  SweepSetup setup;
  RenderArguments render = arguments.render;
  if (render.size.empty()) render.size = arguments.quick ? "128x72" : "256x144";
  setup.settings = parse_render_settings(render);
  if (setup.settings.spp < 2) throw Error(ErrorKind::usage, "--spp: at least 2 are needed");
  setup.quick = arguments.quick;
  setup.budget_s = arguments.quick ? kQuickBudget_s : 300.0;
  if (!arguments.budget.empty()) {
    setup.budget_s = parse_number_in("--budget", arguments.budget, kLeastBudget_s, kMostBudget_s);
  }
  if (!arguments.reference.empty()) {
    setup.truth = color_image(read_image(arguments.reference), arguments.reference);
    setup.truth_file = arguments.reference;
  }
  setup.stop = interrupted;
  return setup;
}

/// Makes the folder, or finds out before the work that it cannot be, nor pictures in it.
void prepare_folder(const std::string& folder) {
  std::error_code failure;
  fs::create_directories(folder + "/images", failure);
  if (failure) throw Error(ErrorKind::failed, folder + ": " + failure.message());
  write_text(folder + "/images/.writable", "");
  fs::remove(folder + "/images/.writable", failure);
  load_codecs();
}

/// That nothing that is read is replaced: how many pictures there will be is not known yet, so their folder is out.
void check_outputs(const CostArguments& arguments, const Scene& scene) {
  std::vector<NamedFile> files = {{"--reference", arguments.reference, true}};
  for (const char* name : {"cost.json", "cost.csv", "report.html"}) {
    files.push_back({"--output", arguments.folder + "/" + name});
  }
  check_not_read(files, scene.files);
  std::vector<std::string> read = scene.files;
  if (!arguments.reference.empty()) read.push_back(arguments.reference);
  const fs::path folder = fs::weakly_canonical(fs::absolute(arguments.folder)) / "images";
  for (const std::string& file : read) {
    if (fs::weakly_canonical(fs::absolute(file)).parent_path() != folder) continue;
    throw Error(ErrorKind::usage, "--output: its pictures could take the place of " + file + ", which is read");
  }
}

void write_pictures(const std::string& folder, const Sweep& sweep, CostNames& names) {
  names.reference_picture = "images/reference.png";
  write_image(folder + "/" + names.reference_picture, file_of_image(sweep.reference.image), DisplayTransform{});
  for (std::size_t i = 0; i < sweep.points.size(); ++i) {
    names.pictures.push_back("images/" + std::to_string(i) + ".png");
    names.maps.push_back("images/" + std::to_string(i) + ".flip.png");
    write_image(folder + "/" + names.pictures[i], file_of_image(sweep.points[i].first_picture), DisplayTransform{});
    write_image(folder + "/" + names.maps[i], flip_map_image(sweep.points[i].first_map), DisplayTransform{});
  }
}

/// Runs the program that VERNIER_REPORT names on `folder`: tools/vernier sets it. False where there is none.
bool make_page(const std::string& folder) {
  const char* program = std::getenv("VERNIER_REPORT");
  if (program == nullptr || *program == '\0') return false;
  char* const arguments[] = {const_cast<char*>(program), const_cast<char*>(folder.c_str()), nullptr};
  pid_t child = 0;
  int status = 0;
  const bool ran = posix_spawn(&child, program, nullptr, nullptr, arguments, environ) == 0 &&
                   waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
  if (!ran) throw Error(ErrorKind::failed, folder + "/report.html: " + program + " failed; cost.json is written");
  return true;
}

void print_choices(const nlohmann::ordered_json& json) {
  std::fputs("sqrt(relMSE) at most  ms on the device  cheapest settings\n", stdout);
  for (const auto& one : json["recommendations"]) {
    std::printf("%-20.3g  %16.1f  %s\n", one["error"].get<double>(), one["device_ms"].get<double>(),
                one["command"].get<std::string>().c_str());
  }
}

Sweep measure(const CostArguments& arguments, SweepSetup& setup, const SceneSetup& scene, CostNames& names) {
  const VulkanInstance instance;
  const DeviceDescription description = choose_device(list_devices(instance), arguments.device);
  prepare_folder(arguments.folder);
  const CachedDevice device(instance, description, pipeline_file(description.pipeline_key));
  ProgressBar bar(arguments.quiet);
  const WorkClock clock;
  setup.progress = [&](double share, std::string_view work) { bar.update(clock.at(share, work)); };
  setup.settings.traversal = calibrated_form(description, scene.scene, setup.settings.traversal);
  Sweep sweep = measure_costs(device.device(), scene.scene, scene.camera, setup);
  names.device = description.name;
  names.driver = description.driver;
  device.store();
  return sweep;
}

int run_cost(const CostArguments& arguments) {
  catch_interrupt();
  const SceneSettings scene_settings = parse_scene_settings(arguments.scene);
  SweepSetup setup = sweep_setup(arguments);
  const SceneSetup scene = set_up_scene(scene_settings, aspect_of(setup.settings));
  print_warnings(scene.scene.warnings);
  check_outputs(arguments, scene.scene);
  CostNames names;
  const Sweep sweep = measure(arguments, setup, scene, names);
  if (sweep.points.empty() && !sweep.complete) {
    std::error_code not_empty;
    fs::remove(arguments.folder + "/images", not_empty);
    throw Error(ErrorKind::failed, arguments.folder + ": interrupted before anything was measured, nothing is written");
  }
  names.scene = arguments.scene.scene;
  names.budget_s = setup.budget_s;
  for (const PointResult& result : sweep.points) {
    names.commands.push_back(point_command(arguments.scene, arguments.render, setup.settings, result.point));
  }
  write_pictures(arguments.folder, sweep, names);
  const nlohmann::ordered_json json = cost_json(sweep, setup, names);
  write_text(arguments.folder + "/cost.csv", cost_csv(sweep));
  write_text(arguments.folder + "/cost.json", json_text(json));
  print_choices(json);
  std::fflush(stdout);
  if (!make_page(arguments.folder)) {
    std::fprintf(stderr, "report.html is made by: tools/report %s\n", shell_word(arguments.folder).c_str());
  }
  if (!sweep.complete) throw Error(ErrorKind::failed, arguments.folder + ": interrupted; it holds what was measured");
  return 0;
}

}  // namespace

void add_cost_command(CLI::App& app, Command& chosen) {
  const auto arguments = std::make_shared<CostArguments>(default_arguments());
  CLI::App& command = *app.add_subcommand(
      "cost",
      "Accuracy against time: renders the scene at many settings and tells which are worth their time here. Writes "
      "cost.json, cost.csv, pictures and, by tools/report, report.html.");
  add_scene_argument(command, arguments->scene.scene, false);
  require_name(*command.add_option("-o,--output", arguments->folder, "folder for the report; made if it is not there")
                    ->type_name("DIR")
                    ->required());
  command.add_flag("--quick", arguments->quick, "a rough answer in less than a minute (default: off)");
  command
      .add_option("--budget", arguments->budget,
                  "wall time of all measurements, seconds, 5 to 86400 (default: 300, with --quick 45)")
      ->type_name("S");
  command
      .add_option("--reference", arguments->reference,
                  "image that counts as the truth (default: rendered, exact, twice as deep)")
      ->type_name("FILE");
  add_size_option(command, arguments->render.size, "256x144, with --quick 128x72");
  command
      .add_option("--spp", arguments->render.spp,
                  "samples per pixel where other settings are compared; at least 2 (default: 16)")
      ->type_name("N");
  add_path_options(command, arguments->render);
  add_filter_options(command, arguments->render);
  add_accuracy_option(command, arguments->render.accuracy);
  add_effects_option(command, arguments->render.effects);
  add_bvh_option(command, arguments->render.bvh);
  add_dispatch_options(command, arguments->render);
  add_traversal_option(command, arguments->render.traversal);
  add_scene_options(command, arguments->scene);
  add_device_option(command, arguments->device);
  command.add_flag("--quiet", arguments->quiet, "no progress; warnings stay (default: off)");
  command.footer("Example: vernier cost scenes/materials.glb -o report --quick");
  command.callback([arguments, &chosen] { chosen = [arguments] { return run_cost(*arguments); }; });
}

}  // namespace vernier
