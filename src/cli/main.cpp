#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <new>

#include "cli/commands.h"
#include "cli/version.h"
#include "error.h"

namespace vernier {
namespace {

int say(ErrorKind kind, const std::string& line) {
  std::fprintf(stderr, "error: %s\n", line.c_str());
  return static_cast<int>(kind);
}

// Parses, prints the help where it is asked for, and says what is wrong in one line otherwise.
int run_command_line(CLI::App& app, const Command& chosen, int argc, char** argv) {
  try {
    app.parse(argc, argv);
    return chosen();
  } catch (const CLI::Success& help_or_version) {
    return app.exit(help_or_version);
  } catch (const CLI::ParseError& error) {
    const std::vector<CLI::App*> command = app.get_subcommands();
    const std::string name = command.empty() ? "vernier" : "vernier " + command.front()->get_name();
    return say(ErrorKind::usage, std::string(error.what()) + "; see " + name + " --help");
  }
}

}  // namespace
}  // namespace vernier

int main(int argc, char** argv) {
  using namespace vernier;
  try {
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
    return run_command_line(app, chosen, argc, argv);
  } catch (const Error& error) {
    return say(error.kind(), error.what());
  } catch (const std::bad_alloc&) {
    return say(ErrorKind::failed, "not enough memory on the host");
  } catch (const std::exception& error) {
    return say(ErrorKind::failed, error.what());
  }
}
