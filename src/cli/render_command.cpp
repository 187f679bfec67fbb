#include "cli/render_command.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "cli/commands.h"
#include "cli/cost_legend.h"
#include "cli/exposure_hint.h"
#include "cli/interrupt.h"
#include "cli/json_text.h"
#include "cli/parse_values.h"
#include "cli/render_report.h"
#include "cli/rendered_image.h"
#include "cli/sample_command.h"
#include "error.h"
#include "image/file_format.h"
#include "image/read_image.h"
#include "image/write_image.h"
#include "render/film_file.h"
#include "shared/film_layout.h"

namespace vernier {
namespace {

void print_summary(const RenderPlan& plan, const RenderReport& report, const ImageFile& image) {
  if (plan.quiet) {
    return;
  }
  if (plan.verbose) {
    std::fputs(verbose_text(report).c_str(), stderr);
  }
  std::fprintf(stderr, "%s\n", summary_line(report, plan.output).c_str());
  // EXR keeps the counts themselves.
  const bool is_shown = file_format(plan.output, ErrorKind::failed) != FileFormat::exr;
  const std::string legend = is_shown ? cost_legend(image) : "";
  if (!legend.empty()) std::fprintf(stderr, "%s\n", legend.c_str());
  const std::string hint = exposure_hint(image, plan.display.exposure_ev);
  if (!hint.empty()) {
    std::fprintf(stderr, "%s\n", hint.c_str());
  }
}

// Nothing takes the place of an older picture.
void check_not_empty(const RenderReport& report, const RenderPlan& plan) {
  if (report.statistics.mean_samples > 0.0) return;
  throw Error(ErrorKind::failed, no_sample_text(plan, report.device.name));
}

// What makes a render that was written a failed one.
void check_outcome(const RenderReport& report, const RenderPlan& plan) {
  const RenderStatistics& statistics = report.statistics;
  if (statistics.non_finite_pixels > 0) {
    throw Error(ErrorKind::failed, plan.output + ": " + non_finite_text(statistics) + "; again by: " +
                                       sample_command(plan, report.device.name, statistics.first_non_finite));
  }
  const bool has_gaps = statistics.stopped && statistics.samples_done == 0;
  if (has_gaps || (statistics.stopped && interrupted())) {
    throw Error(ErrorKind::failed, plan.output + ": " + stop_reason() + "; it holds what was done by then" +
                                       (has_gaps ? ", pixels without a sample are black" : "") +
                                       resume_hint(plan, report.device.name));
  }
}

int run_render(const RenderPlan& plan) {
  catch_interrupt();
  const RenderedImage rendered = render_planned(plan);
  check_not_empty(rendered.report, plan);
  write_image(plan.output, rendered.image, plan.display);
  write_json(plan.json_file, json_text(render_json(rendered.report)));
  print_summary(plan, rendered.report, rendered.image);
  check_outcome(rendered.report, plan);
  return 0;
}

void check_checkpoint_output(const RenderPlan& plan) {
  std::error_code failure;
  if (std::filesystem::is_regular_file(plan.checkpoint, failure) && !is_film_file(plan.checkpoint)) {
    throw Error(ErrorKind::usage,
                "--checkpoint: " + plan.checkpoint + " is there already and is no checkpoint of this version");
  }
}

/// That no output takes the place of another or of what is read.
void check_files(const RenderPlan& plan) {
  std::vector<NamedFile> files = output_files(plan);
  files.push_back({"SCENE", plan.scene.scene, true});
  files.push_back({"--background", plan.scene.background_file, true});
  check_distinct(files);
  // One checkpoint may be both.
  if (plan.resume == plan.checkpoint) return;
  files.push_back({"--resume", plan.resume, true});
  check_distinct(files);
}

/// Whether the image is a part of the samples that can be merged.
bool is_sample_part(const RenderPlan& plan) {
  const bool whole = plan.settings.sample_begin == 0 && plan.settings.sample_end == plan.settings.spp;
  return !whole && file_format(plan.output, ErrorKind::usage) == FileFormat::exr;
}

/// A part that could not be read again could not be merged.
void check_part_size(const PixelRect& area) {
  constexpr std::int64_t kValues = 4 + FILM_WORDS;  // of a pixel, colour and sums
  if (std::int64_t{area.width} * area.height > kMostImageValues / kValues) {
    throw Error(ErrorKind::usage, "--sample-range: a part of more than " + std::to_string(kMostImageValues / kValues) +
                                      " pixels is too large a file to be merged; render it in parts with --crop");
  }
}

}  // namespace

std::vector<NamedFile> output_files(const RenderPlan& plan) {
  std::vector<NamedFile> files = {{"--output", plan.output}, {"--checkpoint", plan.checkpoint}};
  if (plan.json_file != "-") files.push_back({"--json", plan.json_file});
  if (file_format(plan.output, ErrorKind::usage) != FileFormat::exr) {
    for (const std::string& aov : plan.settings.aovs) files.push_back({"--aov", layer_path(plan.output, aov)});
  }
  return files;
}

RenderPlan plan_render(const RenderCommandArguments& arguments) {
  RenderPlan plan;
  plan.scene_arguments = arguments.scene;
  plan.render_arguments = arguments.render;
  plan.scene = parse_scene_settings(arguments.scene);
  plan.settings = parse_render_settings(arguments.render);
  plan.display.exposure_ev = parse_exposure(arguments.exposure);
  plan.exposure = arguments.exposure;
  plan.device = arguments.device;
  plan.output = arguments.output.empty() ? default_image_path(arguments.scene.scene) : arguments.output;
  plan.json_file = arguments.json_file;
  plan.checkpoint = arguments.checkpoint;
  plan.resume = arguments.resume;
  if (!arguments.checkpoint_seconds.empty()) {
    plan.checkpoint_interval_s = parse_number_in("--checkpoint-seconds", arguments.checkpoint_seconds, 0.0, 86400.0);
  }
  plan.quiet = arguments.quiet;
  plan.verbose = arguments.verbose;
  check_image_output(plan.output);
  for (const NamedFile& file : output_files(plan)) check_text_output(file.path);
  const PixelRect area = image_area(plan.settings);
  check_image_size(plan.output, area.width, area.height);
  check_checkpoint_output(plan);
  check_files(plan);
  plan.settings.film_layer = is_sample_part(plan);
  if (plan.settings.film_layer) check_part_size(area);
  return plan;
}

void add_render_command(CLI::App& app, Command& chosen) {
  const auto arguments = std::make_shared<RenderCommandArguments>();
  CLI::App& command =
      *app.add_subcommand("render", "Renders one image; without SCENE the built-in scene that shows every effect.");
  add_scene_argument(command, arguments->scene.scene, false);
  require_name(*command
                    .add_option("-o,--output", arguments->output,
                                "image file: .exr (linear, all layers), .png, .jpg, .hdr or .tif (default: NAME.png of "
                                "the scene here, else vernier.png)")
                    ->type_name("FILE"));
  add_render_options(command, arguments->render);
  add_scene_options(command, arguments->scene);
  add_device_option(command, arguments->device);
  command
      .add_option("--exposure", arguments->exposure,
                  "stops added to .png and .jpg, -100 to 100; the others stay linear (default: 0)")
      ->type_name("EV");
  command
      .add_option(
          "--checkpoint", arguments->checkpoint,
          "saves what is done every 30 seconds, or less often where saving takes more than 1 % of the time, and "
          "when stopped (default: none)")
      ->type_name("FILE");
  command
      .add_option(
          "--resume", arguments->resume,
          "goes on from a checkpoint of the same render: byte for byte the image of one that was never stopped; "
          "where --checkpoint names the same file and it is not there yet, begins (default: none)")
      ->type_name("FILE");
  // For tests: 0 saves after every tile.
  command.add_option("--checkpoint-seconds", arguments->checkpoint_seconds, "seconds between checkpoints")->group("");
  command.add_option("--json", arguments->json_file, "writes statistics (default: none)")->type_name("FILE");
  CLI::Option* quiet =
      command.add_flag("--quiet", arguments->quiet, "no progress and no summary; warnings stay (default: off)");
  command
      .add_flag("--verbose", arguments->verbose,
                "adds device, effects with reasons and times to the summary (default: off)")
      ->excludes(quiet);
  command.footer(
      "Example: vernier render scenes/every_effect.glb -o picture.exr --size 640x360 --spp 64 --aov depth,normal\n"
      "Ctrl-C writes what is done (and the checkpoint) and ends with exit code 1; a second Ctrl-C ends at once.");
  command.callback([arguments, &chosen] { chosen = [arguments] { return run_render(plan_render(*arguments)); }; });
}

}  // namespace vernier
