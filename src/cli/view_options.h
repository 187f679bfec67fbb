#pragma once

#include <string>

#include "cli/render_command.h"

namespace vernier {

/// The texts of `view`'s options.
struct ViewArguments {
  RenderCommandArguments render;  ///< what the window begins with; no output
  std::string script;
  std::string record;
  std::string places;
};

/// `view`'s options in values.
struct ViewSettings {
  SceneSettings scene;
  RenderSettings render;
  float exposure_ev = 0.0f;
};

/// Adds `view` with its options to `app`. `arguments` outlives the parse.
CLI::App& add_view_subcommand(CLI::App& app, ViewArguments& arguments);

/// Reads the texts. Throws Error(usage) that names the option.
ViewSettings parse_view(const ViewArguments& arguments);

}  // namespace vernier
