#include "cli/read_recipe.h"

#include <algorithm>
#include <vector>

#include "cli/parse_values.h"
#include "cli/recipe.h"
#include "error.h"

namespace vernier {
namespace {

using Metadata = std::map<std::string, std::string>;

std::string text_of(const std::string& name, const Metadata& metadata, const std::string& attribute) {
  const auto entry = metadata.find(attribute);
  if (entry == metadata.end()) refuse(name, "its metadata have no " + attribute);
  return entry->second;
}

/// The JSON object in an attribute.
nlohmann::ordered_json object_of(const std::string& name, const Metadata& metadata, const std::string& attribute) {
  auto object = nlohmann::ordered_json::parse(text_of(name, metadata, attribute), nullptr, false);
  if (!object.is_object()) refuse(name, attribute + " in its metadata is no JSON object");
  return object;
}

std::string string_of(const std::string& name, const std::string& option, const nlohmann::ordered_json& value) {
  if (!value.is_string()) refuse(name, "--" + option + " in its metadata is no text");
  return value.get<std::string>();
}

/// What the command line would not take, a file may not ask for.
void check_texts(const std::string& name, const RenderCommandArguments& arguments) {
  try {
    parse_scene_settings(arguments.scene);
    parse_render_settings(arguments.render);
    parse_exposure(arguments.exposure);
  } catch (const Error& error) {
    refuse(name, std::string("in its recipe: ") + error.what());
  }
}

}  // namespace

nlohmann::ordered_json read_options(const std::string& name, const Metadata& metadata) {
  if (!metadata.contains("vernier:options")) refuse(name, "holds no recipe: no metadata of a render by vernier");
  return object_of(name, metadata, "vernier:options");
}

RenderCommandArguments read_recipe(const std::string& name, const Metadata& metadata) {
  RenderCommandArguments arguments;
  const nlohmann::ordered_json options = read_options(name, metadata);
  const std::vector<OptionText> texts = option_texts(arguments.scene, arguments.render);
  for (const auto& [option, value] : options.items()) {
    if (option == "light" && value.is_array()) {
      for (const auto& light : value) arguments.scene.lights.push_back(string_of(name, option, light));
      continue;
    }
    const auto place = std::ranges::find(texts, option, &OptionText::first);
    if (place == texts.end() || place->second == nullptr)
      refuse(name, "its recipe has --" + option + ", which this version does not know");
    *place->second = string_of(name, option, value);
  }
  // OpenEXR keeps no empty text: the built-in scene has no name.
  if (metadata.contains("vernier:scene")) arguments.scene.scene = metadata.at("vernier:scene");
  arguments.device = text_of(name, metadata, "vernier:device");
  if (arguments.device == "reference") refuse(name, "is an image of vernier reference, not of a render");
  if (metadata.contains("vernier:exposure")) arguments.exposure = metadata.at("vernier:exposure");
  check_texts(name, arguments);
  return arguments;
}

void check_scene_files(const std::string& name, const Metadata& metadata) {
  if (!metadata.contains("vernier:scene_sha1")) return;
  const nlohmann::ordered_json files = object_of(name, metadata, "vernier:files");
  for (const auto& [file, digest] : files.items()) {
    const std::vector<std::string> path{file};
    if (sha1_of_files(path) != string_of(name, "files", digest)) {
      refuse(file,
             "is not the file it was when " + name + " was rendered (its SHA-1 was " + digest.get<std::string>() + ")");
    }
  }
}

void check_not_stopped(const std::string& name, const Metadata& metadata) {
  const auto samples = metadata.find("vernier:stopped_at");
  if (samples != metadata.end())
    refuse(name, "was stopped before its end, at " + samples->second + " samples per pixel");
}

}  // namespace vernier
