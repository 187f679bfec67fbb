#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "scene/light.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace vernier {

/// The texts of the options that say what is seen and in which light; empty: not given.
struct SceneArguments {
  std::string scene;
  std::string camera;
  std::string eye;
  std::string target;
  std::string up;
  std::string fov;
  std::string view_height;
  std::vector<std::string> lights;
  std::string background;
  std::string ambient;
  bool strict = false;
};

/// SceneArguments in values, checked.
struct SceneSettings {
  std::string scene;  ///< path, empty for the built-in scene
  std::string camera;
  std::optional<glm::dvec3> eye;     ///< metres
  std::optional<glm::dvec3> target;  ///< metres
  std::optional<glm::dvec3> up;
  std::optional<double> vertical_fov;  ///< radians, in (0, pi)
  std::optional<double> view_height;   ///< metres, above 0: what an orthographic camera sees
  std::vector<Light> lights;           ///< empty: the file's
  std::optional<glm::vec3> background_color;
  std::string background_file;  ///< equirectangular image, empty for none
  std::optional<glm::vec3> ambient;
  bool strict = false;
};

/// Refuses an empty text for `option`: an empty variable of a shell is not meant to be the default.
void require_name(CLI::Option& option);

/// Adds SCENE; without `required` it may be left out for the built-in scene.
void add_scene_argument(CLI::App& app, std::string& scene, bool required);

/// Adds --camera, --eye, --target, --up, --fov, --view-height, --light, --background, --ambient and --strict to `app`.
/// `arguments` outlives the parse.
void add_scene_options(CLI::App& app, SceneArguments& arguments);

/// Reads the texts. A --background that is not a colour is a file if its name ends in an image format's extension.
/// Throws Error(usage) that names the option.
SceneSettings parse_scene_settings(const SceneArguments& arguments);

}  // namespace vernier
