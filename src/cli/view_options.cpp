#include "cli/view_options.h"

#include <CLI/CLI.hpp>

#include "cli/parse_values.h"
#include "error.h"

namespace vernier {

CLI::App& add_view_subcommand(CLI::App& app, ViewArguments& arguments) {
  CLI::App& command = *app.add_subcommand("view", "Opens a window to look around in a scene.");
  RenderCommandArguments& render = arguments.render;
  add_scene_argument(command, render.scene.scene, false);
  add_size_option(command, render.render.size);
  add_sampling_options(command, render.render);
  add_filter_options(command, render.render);
  add_aov_option(command, render.render.aov);
  add_accuracy_option(command, render.render.accuracy);
  add_effects_option(command, render.render.effects);
  add_bvh_option(command, render.render.bvh);
  add_dispatch_options(command, render.render);
  add_scene_options(command, render.scene);
  add_device_option(command, render.device);
  command
      .add_option("--exposure", render.exposure,
                  "stops added to the picture and to saved display images, -100 to 100 (default: 0)")
      ->type_name("EV");
  CLI::Option* script = command.add_option(
      "--script", arguments.script,
      "replays events in place of the user, then closes; one a line; needs --record (default: none)");
  script->type_name("FILE");
  command.add_option("--record", arguments.record, "folder of the script's screenshots (default: none)")
      ->type_name("DIR")
      ->needs(script);
  command.add_flag("--quiet", render.quiet, "as everywhere; the window tells its progress itself (default: off)");
  // For tests: where each widget lies, as JSON, whenever that changes.
  command.add_option("--places", arguments.places)->group("");
  command.footer(
      "Left drag turns, middle drag or left with shift moves across, right drag and wheel go nearer; W A S D Q E "
      "walk,\n"
      "F frames all, 1 to 9 are the file's cameras, R renders, Escape stops, O opens; files may be dropped.\n"
      "Events of a script; # begins a comment, x and y are pixels of the window from its upper left:\n"
      "  wait SECONDS | settle (until the picture has its samples) | shot NAME (writes DIR/NAME.png, or NAME.jpg) | "
      "close\n"
      "  move X Y | press BUTTON | release BUTTON (left, middle, right) | wheel NOTCHES | click WIDGET\n"
      "  key K | hold K | let K (a letter, a digit, escape, enter) | size W H (of the window) | drop FILE | open FILE\n"
      "  set NAME VALUE, as on the command line: Size, Samples, Bounces, Accuracy, Tile, Effects, Exposure, File;\n"
      "  Show 0 to 8: colour, depth, normals, shading normals, albedo, objects, materials, triangles, cost\n"
      "WIDGET: Open, Frame all, Render, Save, Measure, Camera N, a NAME above, or the name of an effect.\n"
      "Example: vernier view scenes/gallery.glb");
  return command;
}

ViewSettings parse_view(const ViewArguments& arguments) {
  if (!arguments.script.empty() && arguments.record.empty()) {
    throw Error(ErrorKind::usage, "--script: it needs --record DIR");
  }
  return {parse_scene_settings(arguments.render.scene), parse_render_settings(arguments.render.render),
          parse_exposure(arguments.render.exposure)};
}

}  // namespace vernier
