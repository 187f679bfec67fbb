#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "cli/render_options.h"
#include "cli/scene_options.h"

namespace vernier {

/// The device and program that made an image.
struct RecipeMaker {
  std::string device;
  std::string driver;
  std::string spirv_hash;  ///< of the trace module, hexadecimal
};

/// An option's name without dashes, and its text; null for `light`, which is a list.
using OptionText = std::pair<std::string, std::string*>;

/// The options that decide the picture, in the order of a recipe.
std::vector<OptionText> option_texts(SceneArguments& scene, RenderArguments& render);

/// The same, as their texts by name without dashes (`size`, `spp`, `light` a list); those
/// not given and without a default are left out. What never changes a bit (tile, dispatch-ms) is left out too.
nlohmann::ordered_json recipe_options(SceneArguments scene, RenderArguments render);

/// SHA-1 of the bytes of the files at `paths` one after the other, 40 hexadecimal digits: for a single file what
/// sha1sum tells of it. Throws Error(refused) for a file that cannot be read.
std::string sha1_of_files(std::span<const std::string> paths);

/// Metadata of what an image shows: vernier:version, vernier:scene, vernier:scene_sha1 (sha1_of_files of `files`, which
/// are Scene::files: buffers, textures, material libraries and the background image count too), vernier:files (JSON
/// text: the SHA-1 of each by its path), vernier:options (JSON text of recipe_options). For the built-in scene
/// vernier:scene is empty; it is part of the program's version, and without files there is no hash.
std::map<std::string, std::string> scene_recipe(const SceneArguments& scene, std::span<const std::string> files,
                                                const RenderArguments& render);

/// Metadata of a rendered image: those of scene_recipe, and vernier:device, vernier:driver, vernier:spirv_hash. Equal
/// renders have equal metadata: no date, no host.
std::map<std::string, std::string> render_recipe(std::map<std::string, std::string> of_scene, const RecipeMaker& maker);

/// The same for an image of the double-precision reference, with vernier:device `reference`.
std::map<std::string, std::string> reference_recipe(std::map<std::string, std::string> of_scene);

}  // namespace vernier
