#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "cli/effect_table.h"
#include "cli/output_file.h"
#include "cli/parse_values.h"
#include "cli/render_options.h"
#include "cli/scene_setup.h"
#include "cli/warnings.h"
#include "effects/detect_effects.h"
#include "image/whole_file.h"

namespace vernier {
namespace {

struct ExplainArguments {
  SceneArguments scene;
  RenderArguments render;
  std::string json_file;
};

int run_explain(const ExplainArguments& arguments) {
  const RenderSettings settings = parse_render_settings(arguments.render);
  const SceneSettings scene_settings = parse_scene_settings(arguments.scene);
  check_text_output(arguments.json_file);
  const double aspect = static_cast<double>(settings.width) / settings.height;
  const SceneSetup setup = set_up_scene(scene_settings, aspect);
  print_warnings(setup.scene.warnings);
  const EffectSet detected = detect_effects(setup.scene, setup.camera, static_cast<int>(settings.max_bounces));
  const EffectSet effects = choose_effects(detected, settings.effects);
  if (!arguments.json_file.empty()) {
    write_text(arguments.json_file, effects_json(setup.scene.source, effects).dump(2) + "\n");
  }
  std::fputs(effect_table(effects).c_str(), stdout);
  return 0;
}

}  // namespace

void add_explain_command(CLI::App& app, Command& chosen) {
  const auto arguments = std::make_shared<ExplainArguments>();
  CLI::App& command =
      *app.add_subcommand("explain", "The effects a scene calls for: on or off, and why. Needs no device.");
  command.add_option("SCENE", arguments->scene.scene, "scene file: .gltf, .glb or .obj")->type_name("")->required();
  add_size_option(command, arguments->render.size);
  add_bounces_option(command, arguments->render.max_bounces);
  add_effects_option(command, arguments->render.effects);
  add_scene_options(command, arguments->scene);
  command.add_option("--json", arguments->json_file, "writes the same as JSON (default: none)")->type_name("FILE");
  command.footer("Example: vernier explain scenes/every_effect.glb --max-bounces 0");
  command.callback([arguments, &chosen] { chosen = [arguments] { return run_explain(*arguments); }; });
}

}  // namespace vernier
