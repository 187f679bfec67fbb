#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "cli/commands.h"
#include "cli/diff_report.h"
#include "cli/output_file.h"
#include "cli/parse_values.h"
#include "image/color_image.h"
#include "image/read_image.h"
#include "image/whole_file.h"
#include "image/write_image.h"

namespace vernier {
namespace {

struct DiffArguments {
  std::string a;
  std::string b;
  std::string exposure = "0";
  std::string json_file;
  std::string map_file;
};

int run_diff(const DiffArguments& arguments) {
  const float exposure_ev = parse_exposure(arguments.exposure);
  check_text_output(arguments.json_file);
  if (!arguments.map_file.empty()) {
    check_image_output(arguments.map_file);
  }
  const Image a = color_image(read_image(arguments.a), arguments.a);
  const Image b = color_image(read_image(arguments.b), arguments.b);
  const DiffReport report{arguments.a, arguments.b, compare_images(a, b), flip(b, a, exposure_ev)};
  if (!arguments.map_file.empty()) {
    write_image(arguments.map_file, flip_map_image(report.flip), DisplayTransform{});
  }
  if (!arguments.json_file.empty()) {
    write_text(arguments.json_file, diff_json(report).dump(2) + "\n");
  }
  std::fputs(diff_table(report).c_str(), stdout);
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
  command.footer("Example: vernier diff render.exr truth.exr --json diff.json --map flip.png");
  command.callback([arguments, &chosen] { chosen = [arguments] { return run_diff(*arguments); }; });
}

}  // namespace vernier
