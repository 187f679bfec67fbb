#include <CLI/CLI.hpp>
#include <algorithm>
#include <string_view>

#include "cli/commands.h"
#include "cli/run_command_line.h"
#include "cli/version.h"
#include "gpu/vector_width.h"

int main(int argc, char** argv) {
  using namespace vernier;
  CLI::App app("Ray tracer on Vulkan compute that says what each bit of accuracy costs.", "vernier");
  app.set_version_flag("--version", kVersion);
  app.require_subcommand(1);
  app.footer(
      "vernier COMMAND --help says more. Exit codes: 0 done, 1 failed, 2 wrong usage, 3 input refused, 4 no usable "
      "device, 5 device lost.");
  Command chosen;
  add_render_command(app, chosen);
  add_view_command(app, chosen, {argv + 1, argv + argc});
  add_explain_command(app, chosen);
  add_cost_command(app, chosen);
  add_reference_command(app, chosen);
  add_diff_command(app, chosen);
  add_merge_command(app, chosen);
  add_rerun_command(app, chosen);
  add_devices_command(app, chosen);
  add_verify_command(app, chosen);
  const Command prepared = [&] {
    const auto asks_for_queries = [](std::string_view word) { return word.ends_with("ray-query"); };
    if (std::any_of(argv + 1, argv + argc, asks_for_queries)) {
      keep_vectors_narrow();  // newer ones of Mesa's drivers have ray queries with those alone
    } else if (!app.got_subcommand("view")) {
      choose_vector_width();  // the window's program looks at the caller's environment
    }
    return chosen();
  };
  return run_command_line(app, prepared, argc, argv);
}
