#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "cli/render_command.h"

namespace vernier {

/// The options in the metadata of the file `name` (vernier:options). Throws Error(refused) where there are none: an
/// image that vernier did not render, or a format that holds no metadata.
nlohmann::ordered_json read_options(const std::string& name, const std::map<std::string, std::string>& metadata);

/// The arguments of `vernier render` that made the image `name` with these metadata (render_recipe), device and
/// exposure too. Throws Error(refused) for what render_recipe did not write, and for an image of `vernier reference`.
RenderCommandArguments read_recipe(const std::string& name, const std::map<std::string, std::string>& metadata);

/// Throws Error(refused) for the first of the scene's files that is not what it was when the image `name` with these
/// metadata was rendered. The built-in scene has no files.
void check_scene_files(const std::string& name, const std::map<std::string, std::string>& metadata);

/// Throws Error(refused) for an image `name` that does not hold all its samples: a render that was stopped.
void check_not_stopped(const std::string& name, const std::map<std::string, std::string>& metadata);

}  // namespace vernier
