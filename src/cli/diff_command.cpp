#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "cli/commands.h"
#include "cli/diff_report.h"
#include "cli/json_text.h"
#include "cli/output_file.h"
#include "cli/parse_values.h"
#include "cli/warnings.h"
#include "error.h"
#include "image/color_image.h"
#include "image/read_image.h"
#include "image/write_image.h"

namespace vernier {
namespace {

struct DiffArguments {
  std::string a;
  std::string b;
  std::string exposure = "0";
  std::string json_file;
  std::string map_file;
  bool quiet = false;  ///< there is no progress to leave out
};

std::string size_text(const Image& image) {
  return std::to_string(image.width) + "x" + std::to_string(image.height);
}

/// The colours of a file; tells where they were never finished.
Image read_whole_image(const std::string& path) {
  const ImageFile file = read_image(path);
  const auto stopped = file.metadata.find("vernier:stopped_at");
  if (stopped != file.metadata.end()) {
    const char* unit = stopped->second.ends_with('%') ? "" : " samples per pixel";  // a share is the reference's
    print_warnings({path + ": its render was stopped before its end, at " + stopped->second + unit});
  }
  return color_image(file, path);
}

int run_diff(const DiffArguments& arguments) {
  const float exposure_ev = parse_exposure(arguments.exposure);
  check_json_output(arguments.json_file);
  if (!arguments.map_file.empty()) {
    check_image_output(arguments.map_file);
  }
  const std::vector<NamedFile> files = {{"A", arguments.a, true},
                                        {"B", arguments.b, true},
                                        {"--map", arguments.map_file},
                                        {"--json", arguments.json_file}};
  check_distinct(files);
  const Image a = read_whole_image(arguments.a);
  const Image b = read_whole_image(arguments.b);
  if (a.width != b.width || a.height != b.height) {
    throw Error(ErrorKind::refused,
                arguments.b + ": is of " + size_text(b) + " pixels, " + arguments.a + " of " + size_text(a));
  }
  const DiffReport report{arguments.a, arguments.b, compare_images(a, b), flip(b, a, exposure_ev)};
  if (!arguments.map_file.empty()) {
    write_image(arguments.map_file, flip_map_image(report.flip), DisplayTransform{});
  }
  write_json(arguments.json_file, json_text(diff_json(report)));
  print_result(arguments.json_file, diff_table(report));
  return 0;
}

}  // namespace

void add_diff_command(CLI::App& app, Command& chosen) {
  const auto arguments = std::make_shared<DiffArguments>();
  CLI::App& command = *app.add_subcommand(
      "diff",
      "How far image A is from the reference B: RMSE, relMSE, PSNR (dB), largest difference, FLIP mean and p99, "
      "pixels that are not finite. Exit code 0 however much they differ.");
  command.add_option("A", arguments->a, "image: .exr .png .jpg .hdr .tif")->type_name("")->required();
  command.add_option("B", arguments->b, "image of the same size, the reference")->type_name("")->required();
  command.add_option("--exposure", arguments->exposure, "stops added to both before FLIP, -100 to 100 (default: 0)")
      ->type_name("EV");
  command.add_option("--json", arguments->json_file, "writes the figures as JSON (default: none)")->type_name("FILE");
  command
      .add_option("--map", arguments->map_file, "writes the FLIP error of each pixel, 0 to 1, as grey (default: none)")
      ->type_name("FILE");
  command.add_flag("--quiet", arguments->quiet, "as everywhere; there is no progress to leave out (default: off)");
  command.footer("Example: vernier diff render.exr truth.exr --json diff.json --map flip.png");
  command.callback([arguments, &chosen] { chosen = [arguments] { return run_diff(*arguments); }; });
}

}  // namespace vernier
