#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "cli/form_report.h"
#include "cli/interrupt.h"
#include "cli/json_text.h"
#include "cli/output_file.h"
#include "cli/progress_bar.h"
#include "cli/scene_setup.h"
#include "error.h"
#include "gpu/describe_devices.h"
#include "render/form_file.h"
#include "render/pipeline_file.h"

namespace vernier {
namespace {

struct DevicesArguments {
  std::string json_file;
  std::string device;
  bool calibrate = false;
  bool quiet = false;
};

/// Times the forms of the traversal with the built-in scene and keeps the best for `description`. Null where it was
/// interrupted.
nlohmann::ordered_json calibrate(const VulkanInstance& instance, const DeviceDescription& description,
                                 const DevicesArguments& arguments) {
  const CachedDevice device(instance, description, pipeline_file(description.pipeline_key));
  FormBench bench;
  const SceneSetup builtin = set_up_scene({}, static_cast<double>(bench.width) / bench.height);
  ProgressBar bar(arguments.quiet);
  const WorkClock clock;
  bench.progress = [&](double share) { bar.update(clock.at(share)); };
  bench.stop = interrupted;
  const std::optional<FormCalibration> calibration =
      calibrate_forms(device.device(), builtin.scene, builtin.camera, bench);
  device.store();
  if (!calibration) return nullptr;
  const FormCalibration& found = *calibration;
  const std::string file = form_file(description.pipeline_key);
  if (!file.empty()) write_form(file, found.best);
  const std::string picture = std::to_string(bench.width) + "x" + std::to_string(bench.height) + ", " +
                              std::to_string(bench.spp) + " samples, " + std::to_string(bench.rounds) + " rounds";
  const std::string kept =
      file.empty() ? "not kept: VERNIER_PIPELINE_CACHE or a home folder names no place" : "kept in " + file;
  print_result(arguments.json_file, "forms of the traversal on " + description.name + ", the built-in scene, " +
                                        picture + ":\n" + form_table(found) + "\n" + kept + "\n");
  return form_json(description.name, found);
}

int run_devices(const DevicesArguments& arguments) {
  catch_interrupt();
  check_json_output(arguments.json_file);
  if (!arguments.device.empty() && !arguments.calibrate) {
    throw Error(ErrorKind::usage, "--device: it says what --calibrate is for, which is not given");
  }
  const VulkanInstance instance;
  const std::vector<DeviceReport> reports = report_devices(instance);
  print_result(arguments.json_file, describe_devices(reports));
  nlohmann::ordered_json json = devices_json(reports);
  if (arguments.calibrate) {
    const DeviceDescription description = choose_device(list_devices(instance), arguments.device);
    json["calibration"] = calibrate(instance, description, arguments);
  }
  write_json(arguments.json_file, json_text(json));
  if (interrupted()) throw Error(ErrorKind::failed, "interrupted; what was done by then is told");
  const bool any = std::ranges::any_of(reports, [](const DeviceReport& report) { return report.device.usable; });
  return any ? 0 : static_cast<int>(ErrorKind::no_device);
}

}  // namespace

void add_devices_command(CLI::App& app, Command& chosen) {
  const auto arguments = std::make_shared<DevicesArguments>();
  CLI::App& command =
      *app.add_subcommand("devices",
                          "Devices, drivers, the limits that matter and what the arithmetic probe found. "
                          "Exit code 4 when none can be used.");
  command.add_option("--json", arguments->json_file, "writes the same as JSON (default: none)")->type_name("FILE");
  command.add_flag("--calibrate", arguments->calibrate,
                   "times every form of the traversal on a device, and keeps the quickest for --traversal auto "
                   "(default: off)");
  command.add_option("--device", arguments->device, "what --calibrate is for (default: the best)")
      ->type_name("INDEX|NAME");
  command.add_flag("--quiet", arguments->quiet, "no progress (default: off)");
  command.footer("Example: vernier devices --calibrate --json devices.json");
  command.callback([arguments, &chosen] { chosen = [arguments] { return run_devices(*arguments); }; });
}

}  // namespace vernier
