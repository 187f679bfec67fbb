#include "cli/run_command_line.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <iostream>
#include <new>

#include "cli/warnings.h"
#include "error.h"

namespace vernier {
namespace {

int say(ErrorKind kind, const std::string& line) {
  std::fprintf(stderr, "error: %s\n", terminal_line(line).c_str());
  return static_cast<int>(kind);
}

/// Refuses values that only a script with an empty variable or a forgotten value can mean.
void check_values(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options()) {
    if (!option->nonpositional()) continue;
    for (const std::string& value : option->results()) {
      if (value.empty()) throw Error(ErrorKind::usage, option->get_name() + ": the value is empty");
      if (value.starts_with("--")) {
        throw Error(ErrorKind::usage, option->get_name() + ": a value is missing before " + value);
      }
    }
  }
}

/// What CLI11 says, but for an option that is given twice, and for arguments that nobody takes, which it has backwards.
std::string usage_text(const CLI::App& app, const CLI::ParseError& error) {
  const std::string text = error.what();
  if (const std::size_t twice = text.find(": At Most 1 required but received "); twice != std::string::npos) {
    return text.substr(0, twice) + ": given more than once";
  }
  if (dynamic_cast<const CLI::ExtrasError*>(&error) == nullptr) return text;
  std::string names;
  for (const std::string& one : app.remaining(true)) names += " " + one;
  return "not expected:" + names;
}

}  // namespace

int run_command_line(CLI::App& app, const Command& chosen, int argc, char** argv) {
  try {
    app.parse(argc, argv);
    for (const CLI::App* command : app.get_subcommands()) check_values(*command);
    const int code = chosen();
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
      throw Error(ErrorKind::failed, "the standard output cannot be written");
    }
    return code;
  } catch (const CLI::Success& help_or_version) {
    const int code = app.exit(help_or_version);
    return std::cout.flush() ? code : say(ErrorKind::failed, "the standard output cannot be written");
  } catch (const CLI::ParseError& error) {
    const std::vector<CLI::App*> command = app.get_subcommands();
    const std::string name = command.empty() ? "vernier" : "vernier " + command.front()->get_name();
    const bool is_unknown = command.empty() && argc > 1 && argv[1][0] != '-';
    const std::string what = is_unknown ? "there is no command `" + std::string(argv[1]) + "`" : usage_text(app, error);
    return say(ErrorKind::usage, what + "; see " + name + " --help");
  } catch (const Error& error) {
    return say(error.kind(), error.what());
  } catch (const std::bad_alloc&) {
    return say(ErrorKind::failed, "not enough memory on the host");
  } catch (const std::exception& error) {
    return say(ErrorKind::failed, error.what());
  }
}

}  // namespace vernier
