#pragma once

#include "cli/commands.h"

namespace vernier {

/// Parses the words with `app`, runs what they have made `chosen` be, and returns the program's exit code: the help
/// where it is asked for, and one line on stderr for wrong usage and any failure.
int run_command_line(CLI::App& app, const Command& chosen, int argc, char** argv);

}  // namespace vernier
