#include "cli/scene_options.h"

#include <CLI/CLI.hpp>
#include <glm/gtc/constants.hpp>

#include "cli/parse_light.h"
#include "cli/parse_values.h"
#include "error.h"
#include "image/file_format.h"

namespace vernier {
namespace {

std::optional<glm::dvec3> optional_vec3(const std::string& option, const std::string& text) {
  return text.empty() ? std::nullopt : std::optional(parse_vec3(option, text));
}

double parse_fov(const std::string& text) {
  const double degrees = parse_number("--fov", text);
  if (!(degrees > 0.0 && degrees < 180.0)) {
    throw Error(ErrorKind::usage, "--fov: `" + text + "` is not an angle between 0 and 180 degrees");
  }
  return glm::radians(degrees);
}

double parse_view_height(const std::string& text) {
  constexpr double kLeast_m = 1e-30, kMost_m = 1e30;  // within float32, in which rays start
  return parse_number_in("--view-height", text, kLeast_m, kMost_m);
}

// A colour holds digits, signs, dots, exponents and commas only, so no name with a known extension is one.
void parse_background(const std::string& text, SceneSettings& settings) {
  if (text.find_first_not_of("0123456789.,+-eE") == std::string::npos) {
    settings.background_color = parse_color("--background", text);
  } else {
    try {
      file_format(text, ErrorKind::refused);
    } catch (const Error& error) {
      throw Error(error.kind(), std::string("--background: neither three numbers nor an image: ") + error.what());
    }
    settings.background_file = text;
  }
}

}  // namespace

void require_name(CLI::Option& option) {
  option.check(
      CLI::Validator([](const std::string& name) { return std::string(name.empty() ? "the name is empty" : ""); }, ""));
}

void add_scene_argument(CLI::App& app, std::string& scene, bool required) {
  const std::string help = "scene file: .gltf, .glb or .obj";
  CLI::Option& option =
      *app.add_option("SCENE", scene, required ? help : help + " (default: the built-in scene)")->type_name("");
  option.required(required);
  require_name(option);
}

void add_scene_options(CLI::App& app, SceneArguments& arguments) {
  const char* group = "What is seen";
  app.add_option("--camera", arguments.camera,
                 "camera of the file, by name or index from 0 (default: the first; a file without one is framed whole)")
      ->type_name("NAME|INDEX")
      ->group(group);
  app.add_option("--eye", arguments.eye, "eye in metres (default: the camera's)")->type_name("x,y,z")->group(group);
  app.add_option("--target", arguments.target,
                 "point looked at in metres (default: the camera's; with --eye alone the scene's centre)")
      ->type_name("x,y,z")
      ->group(group);
  app.add_option("--up", arguments.up,
                 "direction that is up in the image (default: the camera's; 0,1,0 with --eye or --target)")
      ->type_name("x,y,z")
      ->group(group);
  app.add_option("--fov", arguments.fov,
                 "vertical field of view in degrees, between 0 and 180 (default: the camera's, else 45)")
      ->type_name("DEG")
      ->group(group);
  app.add_option("--view-height", arguments.view_height,
                 "height of what an orthographic camera sees, in metres (default: the camera's)")
      ->type_name("M")
      ->group(group);
  app.add_option("--light", arguments.lights,
                 "point:x,y,z:r,g,b (metres, candela) or dir:x,y,z:r,g,b (the way the light travels, lux); repeatable, "
                 "replaces the "
                 "file's lights (default: the file's, else a key and a fill light beside the camera)")
      ->type_name("LIGHT")
      ->allow_extra_args(false)
      ->group(group);
  app.add_option("--background", arguments.background,
                 "linear radiance, or an equirectangular image (default: a soft gradient, dim beside the file's "
                 "lights or --light)")
      ->type_name("r,g,b|FILE")
      ->group(group);
  app.add_option("--ambient", arguments.ambient,
                 "linear radiance of the ambient light (default: that of the background)")
      ->type_name("r,g,b")
      ->group(group);
  app.add_flag("--strict", arguments.strict,
               "a feature of the file that is not supported is an error with exit code 3, not a warning (default: off)")
      ->group(group);
}

SceneSettings parse_scene_settings(const SceneArguments& arguments) {
  SceneSettings settings;
  settings.scene = arguments.scene;
  settings.camera = arguments.camera;
  settings.eye = optional_vec3("--eye", arguments.eye);
  settings.target = optional_vec3("--target", arguments.target);
  settings.up = optional_vec3("--up", arguments.up);
  settings.strict = arguments.strict;
  if (!arguments.fov.empty()) {
    settings.vertical_fov = parse_fov(arguments.fov);
  }
  if (!arguments.view_height.empty()) {
    settings.view_height = parse_view_height(arguments.view_height);
  }
  for (const std::string& light : arguments.lights) {
    settings.lights.push_back(parse_light(light));
  }
  if (!arguments.background.empty()) {
    parse_background(arguments.background, settings);
  }
  if (!arguments.ambient.empty()) {
    settings.ambient = parse_color("--ambient", arguments.ambient);
  }
  return settings;
}

}  // namespace vernier
