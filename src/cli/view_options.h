#pragma once

#include "cli/render_options.h"
#include "cli/scene_options.h"

namespace vernier {

/// The texts of `view`'s options.
struct ViewArguments {
  SceneArguments scene;
  RenderArguments render;
  std::string device;
  std::string exposure = "0";
};

/// `view`'s options in values.
struct ViewSettings {
  SceneSettings scene;
  RenderSettings render;
  std::string device;
  float exposure_ev = 0.0f;
};

/// Adds `view` with its options to `app`. `arguments` outlives the parse.
CLI::App& add_view_subcommand(CLI::App& app, ViewArguments& arguments);

/// Reads the texts. Throws Error(usage) that names the option.
ViewSettings parse_view(const ViewArguments& arguments);

}  // namespace vernier
