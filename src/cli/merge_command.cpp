#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "cli/commands.h"
#include "cli/cost_legend.h"
#include "cli/json_text.h"
#include "cli/match_recipes.h"
#include "cli/output_file.h"
#include "cli/parse_values.h"
#include "cli/read_recipe.h"
#include "cli/render_options.h"
#include "error.h"
#include "image/file_format.h"
#include "image/read_image.h"
#include "image/write_image.h"
#include "render/merge_parts.h"

namespace vernier {
namespace {

struct MergeArguments {
  std::vector<std::string> parts;
  std::string output;
  bool quiet = false;
};

/// An EXR file with what its recipe says of its samples.
ImagePart read_part(const std::string& file) {
  if (file_format(file, ErrorKind::refused) != FileFormat::exr) {
    throw Error(ErrorKind::refused, file + ": only EXR files hold the bits that merging takes");
  }
  ImagePart part{file, read_image(file), 0, 0};
  const RenderCommandArguments recipe = read_recipe(file, part.image.metadata);
  check_not_stopped(file, part.image.metadata);
  const RenderSettings settings = parse_render_settings(recipe.render);
  if (settings.error_target) {
    throw Error(ErrorKind::refused, file + ": rendered with --error-target, it is no part of a larger image");
  }
  part.sample_begin = settings.sample_begin;
  part.sample_end = settings.sample_end;
  return part;
}

/// The metadata of the whole image that `part` is a part of.
std::map<std::string, std::string> whole_recipe(const ImagePart& part) {
  std::map<std::string, std::string> metadata = part.image.metadata;
  nlohmann::ordered_json options = read_options(part.name, metadata);
  options.erase("crop");
  options.erase("sample-range");
  metadata["vernier:options"] = json_line(options);
  metadata.erase("vernier:cost_legend");
  metadata.try_emplace("vernier:scene", "");  // not kept where empty
  return metadata;
}

int run_merge(const MergeArguments& arguments) {
  check_image_output(arguments.output);
  std::vector<NamedFile> files;
  for (const std::string& part : arguments.parts) files.push_back({"PART", part, true});
  files.push_back({"--output", arguments.output});
  check_distinct(files);
  std::vector<ImagePart> parts;
  for (const std::string& file : arguments.parts) {
    parts.push_back(read_part(file));
    match_recipes(parts.front().name, parts.front().image.metadata, file, parts.back().image.metadata,
                  {"crop", "sample-range"});
  }
  const RenderCommandArguments recipe = read_recipe(parts.front().name, parts.front().image.metadata);
  const RenderSettings settings = parse_render_settings(recipe.render);
  ImageFile image = merge_parts(parts, settings.spp, settings.aovs);
  image.metadata = whole_recipe(parts.front());
  const std::string legend = cost_legend(image);
  if (!legend.empty()) image.metadata["vernier:cost_legend"] = legend;
  write_image(arguments.output, image, {parse_exposure(recipe.exposure)});
  if (arguments.quiet) return 0;
  std::fprintf(stderr, "%s: %dx%d, %u samples, of %zu %s\n", arguments.output.c_str(), image.width, image.height,
               settings.spp, parts.size(), parts.size() == 1 ? "part" : "parts");
  return 0;
}

}  // namespace

void add_merge_command(CLI::App& app, Command& chosen) {
  const auto arguments = std::make_shared<MergeArguments>();
  CLI::App& command = *app.add_subcommand(
      "merge",
      "Puts crops (--crop) and parts of the samples (--sample-range) of one image together: the bits of one render. "
      "Parts that overlap, leave something out or are of another scene, setting, device or version are refused.");
  command.add_option("PART", arguments->parts, "EXR files of vernier render, in any order")->type_name("")->required();
  command.add_option("-o,--output", arguments->output, "image file: .exr, .png, .jpg, .hdr or .tif")
      ->type_name("FILE")
      ->required();
  command.add_flag("--quiet", arguments->quiet, "no summary (default: off)");
  command.footer(
      "Example: vernier merge a0.exr a1.exr -o a.exr\n"
      "Parts: vernier render a.glb -o a0.exr --sample-range 0:8; vernier render a.glb -o a1.exr --sample-range 8:16");
  command.callback([arguments, &chosen] { chosen = [arguments] { return run_merge(*arguments); }; });
}

}  // namespace vernier
