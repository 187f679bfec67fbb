#include "cli/recipe.h"

#include <OpenImageIO/hash.h>

#include <array>
#include <fstream>

#include "cli/json_text.h"
#include "cli/version.h"
#include "error.h"

namespace vernier {
namespace {

/// `of_all` is that of all files, one after the other: of one file too, which is not hashed again.
nlohmann::ordered_json sha1_by_path(std::span<const std::string> files, const std::string& of_all) {
  nlohmann::ordered_json digests;
  if (files.size() == 1) {
    digests[files[0]] = of_all;
    return digests;
  }
  for (const std::string& file : files) digests[file] = sha1_of_files(std::span(&file, 1));
  return digests;
}

void append_file(OIIO::SHA1& hash, const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::array<char, 1 << 16> block;
  while (file.read(block.data(), block.size()) || file.gcount() > 0) {
    hash.append(block.data(), static_cast<std::size_t>(file.gcount()));
  }
  if (!file.eof()) {
    throw Error(ErrorKind::refused, path + ": cannot be read");
  }
}

}  // namespace

std::vector<OptionText> option_texts(SceneArguments& scene, RenderArguments& render) {
  return {{"size", &render.size},
          {"crop", &render.crop},
          {"camera", &scene.camera},
          {"eye", &scene.eye},
          {"target", &scene.target},
          {"up", &scene.up},
          {"fov", &scene.fov},
          {"view-height", &scene.view_height},
          {"light", nullptr},
          {"background", &scene.background},
          {"ambient", &scene.ambient},
          {"spp", &render.spp},
          {"error-target", &render.error_target},
          {"sample-range", &render.sample_range},
          {"max-bounces", &render.max_bounces},
          {"cutoff", &render.cutoff},
          {"accuracy", &render.accuracy},
          {"effects", &render.effects},
          {"filter", &render.filter},
          {"texture-filter", &render.texture_filter},
          {"bvh", &render.bvh},  // no colour hangs on it, but the layer cost does
          {"traversal", &render.traversal},
          {"aov", &render.aov},
          {"seed", &render.seed}};
}

nlohmann::ordered_json recipe_options(SceneArguments scene, RenderArguments render) {
  render.spp = spp_text(render);
  // No bit hangs on it, but its shaders have a hash of their own.
  if (render.traversal == "auto") render.traversal.clear();
  nlohmann::ordered_json options;
  for (const auto& [name, text] : option_texts(scene, render)) {
    if (text == nullptr) {
      if (!scene.lights.empty()) options[name] = scene.lights;
    } else if (!text->empty()) {
      options[name] = *text;
    }
  }
  return options;
}

std::string sha1_of_files(std::span<const std::string> paths) {
  OIIO::SHA1 hash;
  for (const std::string& path : paths) {
    append_file(hash, path);
  }
  std::string digits = hash.digest();
  for (char& digit : digits) {
    digit = digit >= 'A' && digit <= 'F' ? static_cast<char>(digit - 'A' + 'a') : digit;
  }
  return digits;
}

std::map<std::string, std::string> scene_recipe(const SceneArguments& scene, std::span<const std::string> files,
                                                const RenderArguments& render) {
  std::map<std::string, std::string> metadata;
  metadata["vernier:version"] = kVersion;
  metadata["vernier:scene"] = scene.scene;
  metadata["vernier:options"] = json_line(recipe_options(scene, render));
  if (!files.empty()) {
    const std::string of_all = sha1_of_files(files);
    metadata["vernier:scene_sha1"] = of_all;
    metadata["vernier:files"] = json_line(sha1_by_path(files, of_all));
  }
  return metadata;
}

std::map<std::string, std::string> render_recipe(std::map<std::string, std::string> of_scene,
                                                 const RecipeMaker& maker) {
  of_scene["vernier:device"] = maker.device;
  of_scene["vernier:driver"] = maker.driver;
  of_scene["vernier:spirv_hash"] = maker.spirv_hash;
  return of_scene;
}

std::map<std::string, std::string> reference_recipe(std::map<std::string, std::string> of_scene) {
  of_scene["vernier:device"] = "reference";
  return of_scene;
}

}  // namespace vernier
