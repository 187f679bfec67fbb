#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "cli/render_options.h"
#include "cli/scene_options.h"

namespace vernier {

/// The device and program that made an image.
struct RecipeMaker {
  std::string device;
  std::string driver;
  std::string spirv_hash;  ///< of the trace module, hexadecimal
};

/// The options that decide the picture, as their texts by name without dashes (`size`, `spp`, `light` a list); those
/// not given and without a default are left out. What never changes a bit (tile, dispatch-ms) is left out too.
nlohmann::ordered_json recipe_options(const SceneArguments& scene, const RenderArguments& render);

/// SHA-1 of the bytes of the file at `path`, 40 hexadecimal digits; not of the files it refers to.
/// Throws Error(refused) for a file that cannot be read.
std::string sha1_of_file(const std::string& path);

/// Metadata of a rendered image: vernier:version, vernier:scene, vernier:scene_sha1, vernier:options (JSON text of
/// recipe_options), vernier:device, vernier:driver, vernier:spirv_hash. Equal renders have equal metadata: no date,
/// no host. For the built-in scene vernier:scene is empty and there is no hash: it is part of the program's version.
std::map<std::string, std::string> render_recipe(const SceneArguments& scene, const RenderArguments& render,
                                                 const RecipeMaker& maker);

/// The same for an image of the double-precision reference, with vernier:device `reference`.
std::map<std::string, std::string> reference_recipe(const SceneArguments& scene, const RenderArguments& render);

}  // namespace vernier
