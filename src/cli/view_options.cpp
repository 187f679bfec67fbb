#include "cli/view_options.h"

#include "cli/parse_values.h"

namespace vernier {

CLI::App& add_view_subcommand(CLI::App& app, ViewArguments& arguments) {
  CLI::App& command = *app.add_subcommand("view", "Opens a window to look around in a scene.");
  command.add_option("SCENE", arguments.scene.scene, "scene file: .gltf, .glb or .obj (default: the built-in scene)")
      ->type_name("");
  add_render_options(command, arguments.render);
  add_scene_options(command, arguments.scene);
  command
      .add_option("--device", arguments.device, "index or part of the name, see vernier devices (default: the best)")
      ->type_name("INDEX|NAME");
  command.add_option("--exposure", arguments.exposure, "stops, -100 to 100 (default: 0)")->type_name("EV");
  command.footer(
      "Example: vernier view scenes/gallery.glb\n"
      "Left drag turns, middle drag or left with shift moves across, right drag and wheel go nearer; W A S D Q E walk, "
      "F frames all, 1 to 9 are the file's cameras; files may be dropped.");
  return command;
}

ViewSettings parse_view(const ViewArguments& arguments) {
  return {parse_scene_settings(arguments.scene), parse_render_settings(arguments.render), arguments.device,
          parse_exposure(arguments.exposure)};
}

}  // namespace vernier
