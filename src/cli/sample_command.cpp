#include "cli/sample_command.h"

#include <algorithm>
#include <cctype>
#include <string_view>

#include "cli/recipe.h"

namespace vernier {
namespace {

bool is_plain(char c) {
  constexpr std::string_view kPlainSigns = "_-+=:,./%@";
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || kPlainSigns.find(c) != std::string_view::npos;
}

/// " --name value"; a value that starts like an option is tied to its name.
std::string option(const std::string& name, const std::string& value) {
  if (value.starts_with('-')) return " " + shell_word("--" + name + "=" + value);
  return " --" + name + " " + shell_word(value);
}

}  // namespace

std::string shell_word(const std::string& text) {
  if (!text.empty() && std::ranges::all_of(text, is_plain)) return text;
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

std::string sample_command(const RenderPlan& plan, const std::string& device, const SamplePlace& place) {
  RenderArguments render = plan.render_arguments;
  render.crop = std::to_string(place.x) + "," + std::to_string(place.y) + ",1,1";
  render.sample_range = std::to_string(place.sample) + ":" + std::to_string(place.sample + 1);
  render.aov.clear();
  std::string command = "vernier render";
  if (!plan.scene_arguments.scene.empty()) command += " " + shell_word(plan.scene_arguments.scene);
  command += " -o sample.exr";
  const nlohmann::ordered_json options = recipe_options(plan.scene_arguments, render);
  for (const auto& [name, value] : options.items()) {
    if (value.is_array()) {
      for (const auto& each : value) command += option(name, each.get<std::string>());
    } else {
      command += option(name, value.get<std::string>());
    }
  }
  return command + option("device", device);
}

}  // namespace vernier
