#include "cli/sample_command.h"

#include <algorithm>
#include <cctype>
#include <string_view>

#include "cli/interrupt.h"
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

/// The command that renders `scene` to `output` with `options` of the recipe.
std::string command_of(const std::string& scene, const std::string& output, const nlohmann::ordered_json& options) {
  std::string command = "vernier render";
  if (!scene.empty()) command += " " + shell_word(scene);
  command += " -o " + shell_word(output);
  for (const auto& [name, value] : options.items()) {
    if (value.is_array()) {
      for (const auto& each : value) command += option(name, each.get<std::string>());
    } else {
      command += option(name, value.get<std::string>());
    }
  }
  return command;
}

/// The same with every option.
std::string render_command(const SceneArguments& scene, const RenderArguments& render, const std::string& output) {
  return command_of(scene.scene, output, recipe_options(scene, render));
}

}  // namespace

std::string short_render_command(const SceneArguments& scene, const RenderArguments& render,
                                 const std::string& output) {
  const nlohmann::ordered_json defaults = recipe_options({}, {});
  nlohmann::ordered_json options = nlohmann::ordered_json::object();
  const nlohmann::ordered_json all = recipe_options(scene, render);
  for (const auto& [name, value] : all.items()) {
    if (!defaults.contains(name) || defaults[name] != value) options[name] = value;
  }
  if (render.spp.empty()) options.erase("spp");
  return command_of(scene.scene, output, options);
}

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
  // An error target goes with neither; of its samples the most that a pixel gets say where each one lies.
  render.spp = spp_text(render);
  render.error_target.clear();
  render.aov.clear();
  return render_command(plan.scene_arguments, render, "sample.exr") + option("device", device);
}

std::string resume_hint(const RenderPlan& plan, const std::string& device) {
  if (plan.checkpoint.empty()) return "";
  std::string command = render_command(plan.scene_arguments, plan.render_arguments, plan.output);
  if (plan.exposure != "0") command += option("exposure", plan.exposure);
  if (!plan.json_file.empty()) command += option("json", plan.json_file);
  return "; go on by: " + command + option("device", device) + option("checkpoint", plan.checkpoint) +
         option("resume", plan.checkpoint);
}

std::string stop_reason() {
  return interrupted() ? "interrupted" : "--time-limit ended it";
}

std::string no_sample_text(const RenderPlan& plan, const std::string& device) {
  return plan.output + ": " + stop_reason() + " before the first sample, nothing is written" +
         resume_hint(plan, device);
}

}  // namespace vernier
