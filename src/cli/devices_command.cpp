#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "cli/output_file.h"
#include "error.h"
#include "gpu/describe_devices.h"
#include "image/whole_file.h"

namespace vernier {
namespace {

int run_devices(const std::string& json_file) {
  check_text_output(json_file);
  const VulkanInstance instance;
  const std::vector<DeviceReport> reports = report_devices(instance);
  if (!json_file.empty()) {
    write_text(json_file, devices_json(reports).dump(2) + "\n");
  }
  std::fputs(describe_devices(reports).c_str(), stdout);
  for (const DeviceReport& report : reports) {
    if (report.device.usable) {
      return 0;
    }
  }
  return static_cast<int>(ErrorKind::no_device);
}

}  // namespace

void add_devices_command(CLI::App& app, Command& chosen) {
  const auto json_file = std::make_shared<std::string>();
  CLI::App& command =
      *app.add_subcommand("devices",
                          "Devices, drivers, the limits that matter and what the arithmetic probe found. "
                          "Exit code 4 when none can be used.");
  command.add_option("--json", *json_file, "writes the same as JSON (default: none)")->type_name("FILE");
  command.footer("Example: vernier devices --json devices.json");
  command.callback([json_file, &chosen] { chosen = [json_file] { return run_devices(*json_file); }; });
}

}  // namespace vernier
