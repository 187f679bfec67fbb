#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>

#include "cli/commands.h"
#include "cli/interrupt.h"
#include "cli/read_recipe.h"
#include "cli/rendered_image.h"
#include "cli/warnings.h"
#include "error.h"
#include "gpu/vector_width.h"
#include "image/layer_differences.h"
#include "image/read_image.h"
#include "image/write_image.h"

namespace vernier {
namespace {

namespace fs = std::filesystem;

struct RerunArguments {
  std::string image;
  std::string device;
  bool quiet = false;
};

/// A folder of its own that goes with what is in it.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::error_code failure;
    const fs::path place = fs::temp_directory_path(failure);
    if (failure) throw Error(ErrorKind::failed, "TMPDIR: there is no folder for temporary files");
    std::string name = (place / "vernier-rerun-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw Error(ErrorKind::failed, name + ": cannot be made");
    path_ = name;
  }
  ~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

/// `image` as it comes back from the file that `plan` names, or that of `layer` alone where it has a name: what was
/// rounded in the original is rounded here.
ImageFile through_file(const RenderPlan& plan, const ImageFile& image, const std::string& layer) {
  write_image(plan.output, image, plan.display);
  return read_image(layer_path(plan.output, layer));
}

/// Tells of what else may be the reason for other bits.
void warn_of_other_maker(const ImageFile& original, const ImageFile& image) {
  for (const char* name : {"vernier:version", "vernier:device", "vernier:driver", "vernier:spirv_hash"}) {
    const auto before = original.metadata.find(name), now = image.metadata.find(name);
    if (before == original.metadata.end() || now == image.metadata.end() ||
        without_vector_width(before->second) == now->second)
      continue;
    print_warnings({std::string(name) + " was `" + before->second + "` and is `" + now->second + "`"});
  }
}

int run_rerun(const RerunArguments& arguments) {
  const ImageFile original = read_image(arguments.image);
  RenderCommandArguments recipe = read_recipe(arguments.image, original.metadata);
  check_not_stopped(arguments.image, original.metadata);
  check_scene_files(arguments.image, original.metadata);
  const ScratchFolder folder;
  recipe.output = (folder.path() / ("again" + fs::path(arguments.image).extension().string())).string();
  recipe.quiet = arguments.quiet;
  if (!arguments.device.empty()) recipe.device = arguments.device;
  const RenderPlan plan = plan_render(recipe);
  catch_interrupt();
  const RenderedImage again = render_planned(plan);
  if (interrupted()) throw Error(ErrorKind::failed, arguments.image + ": interrupted before it was compared");
  warn_of_other_maker(original, again.image);

  const auto layer = original.metadata.find("vernier:layer");
  const std::string layer_name = layer == original.metadata.end() ? "" : layer->second;
  const std::vector<std::string> lines = layer_differences(original, through_file(plan, again.image, layer_name));
  if (lines.empty()) {
    std::printf("%s: the same bits again, %dx%d pixels, %zu %s\n", arguments.image.c_str(), original.width,
                original.height, original.layers.size(), original.layers.size() == 1 ? "layer" : "layers");
    return 0;
  }
  for (const std::string& line : lines) std::printf("%s\n", line.c_str());
  throw Error(ErrorKind::failed, arguments.image + ": the render is another now");
}

}  // namespace

void add_rerun_command(CLI::App& app, Command& chosen) {
  const auto arguments = std::make_shared<RerunArguments>();
  CLI::App& command = *app.add_subcommand(
      "rerun",
      "Renders again from the recipe in the image's metadata, on the same device, and compares bit by bit. Exit code "
      "0: "
      "the same; 1: another, with a line for each layer; 3: a file of the scene has changed, or there is no recipe.");
  command.add_option("IMAGE", arguments->image, "image of vernier render: .exr .png .jpg .tif")
      ->type_name("")
      ->required();
  command
      .add_option("--device", arguments->device,
                  "index or part of the name, see vernier devices (default: the one of the recipe)")
      ->type_name("INDEX|NAME");
  command.add_flag("--quiet", arguments->quiet, "no progress (default: off)");
  command.footer(
      "Example: vernier rerun picture.exr\nThe scene is looked for at the path that render was given: a relative one "
      "from the folder where rerun runs.");
  command.callback([arguments, &chosen] { chosen = [arguments] { return run_rerun(*arguments); }; });
}

}  // namespace vernier
