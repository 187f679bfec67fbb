#pragma once

#include <functional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace vernier {

/// What the program does once the command line is read. Returns the exit code; throws Error for any failure.
using Command = std::function<int()>;

// Each of these adds its subcommand to `app`, with options, defaults and an example; when the command line names it,
// `chosen` becomes the command to run. `chosen` outlives the parse.

/// `vernier render`: one image.
void add_render_command(CLI::App& app, Command& chosen);
/// `vernier explain`: the effects of a scene and why.
void add_explain_command(CLI::App& app, Command& chosen);
/// `vernier cost`: accuracy against time.
void add_cost_command(CLI::App& app, Command& chosen);
/// `vernier reference`: the double-precision image.
void add_reference_command(CLI::App& app, Command& chosen);
/// `vernier diff`: figures of two images.
void add_diff_command(CLI::App& app, Command& chosen);
/// `vernier merge`: parts into one image.
void add_merge_command(CLI::App& app, Command& chosen);
/// `vernier rerun`: an image again from its own recipe.
void add_rerun_command(CLI::App& app, Command& chosen);
/// `vernier devices`: what there is to render on.
void add_devices_command(CLI::App& app, Command& chosen);
/// `vernier view`: a window; `words` are those of the command line behind the program's name.
void add_view_command(CLI::App& app, Command& chosen, std::vector<std::string> words);
/// `vernier verify`: the numeric suite.
void add_verify_command(CLI::App& app, Command& chosen);

}  // namespace vernier
