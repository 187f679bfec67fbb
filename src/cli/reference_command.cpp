#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <memory>

#include "cli/commands.h"
#include "cli/interrupt.h"
#include "cli/output_file.h"
#include "cli/parse_values.h"
#include "cli/progress_bar.h"
#include "cli/recipe.h"
#include "cli/render_options.h"
#include "cli/scene_setup.h"
#include "cli/warnings.h"
#include "error.h"
#include "image/codec_module.h"
#include "image/file_format.h"
#include "image/write_image.h"
#include "reference/render_reference.h"
#include "reference/traced_scene.h"
#include "render/memory_need.h"

namespace vernier {
namespace {

constexpr std::uint32_t kMaxThreads = 1024;

struct ReferenceArguments {
  SceneArguments scene;
  RenderArguments render;
  std::string output;
  std::string exposure = "0";
  std::string threads = "0";
  bool quiet = false;
};

ReferenceSettings reference_settings(const ReferenceArguments& arguments) {
  const RenderSettings render = parse_render_settings(arguments.render);
  ReferenceSettings settings;
  settings.width = render.width;
  settings.height = render.height;
  settings.spp = render.spp;
  settings.max_bounces = render.max_bounces;
  settings.cutoff = parse_number("--cutoff", arguments.render.cutoff);  // in double, as given
  settings.seed = render.seed;
  settings.tent_filter = render.pixel_filter == PixelFilter::tent;
  settings.thread_count = parse_count("--threads", arguments.threads, 0, kMaxThreads);
  return settings;
}

/// The reference looks textures up as the scene says, so the scene is told.
void set_texture_filters(Scene& scene, const RenderArguments& arguments) {
  const TextureFilter filter = parse_render_settings(arguments).texture_filter;
  if (filter == TextureFilter::file) return;
  for (std::size_t i = 0; i < scene.textures.size(); ++i) {
    if (static_cast<int>(i) == scene.environment.texture) continue;
    scene.textures[i].sampler.filter =
        filter == TextureFilter::nearest ? TEXTURE_FILTER_NEAREST : TEXTURE_FILTER_LINEAR;
  }
}

/// A picture, and how much of it is there.
struct ReferencePicture {
  ImageFile image;
  double share = 0.0;  ///< of the work, done
};

ReferencePicture render_with_progress(const SceneSetup& setup, const ReferenceSettings& settings, bool quiet) {
  ReferencePicture picture;
  ProgressBar bar(quiet);
  const WorkClock clock;
  ReferenceCallbacks callbacks;
  callbacks.progress = [&](double share) {
    picture.share = share;
    bar.update(clock.at(share));
  };
  callbacks.cancelled = interrupted;
  picture.image = render_reference(setup.scene, setup.camera, settings, callbacks);
  return picture;
}

int run_reference(const ReferenceArguments& arguments) {
  catch_interrupt();
  const ReferenceSettings settings = reference_settings(arguments);
  const SceneSettings scene_settings = parse_scene_settings(arguments.scene);
  const DisplayTransform display{parse_exposure(arguments.exposure)};
  check_image_output(arguments.output);
  check_image_size(arguments.output, settings.width, settings.height);
  const std::vector<NamedFile> files = {{"SCENE", scene_settings.scene, true},
                                        {"--background", scene_settings.background_file, true},
                                        {"--output", arguments.output}};
  check_distinct(files);
  SceneSetup setup = set_up_scene(scene_settings, static_cast<double>(settings.width) / settings.height);
  check_not_read(files, setup.scene.files);
  // All instances are copied here, on purpose: nothing of the tracer's is shared.
  check_memory(setup.scene.source, need_of_copies(setup.scene, reference::kTriangleBytes), memory_there());
  load_codecs();  // before the work: without them it could not be written
  set_texture_filters(setup.scene, arguments.render);
  print_warnings(setup.scene.warnings);
  auto [image, done] = render_with_progress(setup, settings, arguments.quiet);
  if (file_format(arguments.output, ErrorKind::usage) != FileFormat::exr) image.layers.resize(1);  // the colours
  image.metadata.merge(reference_recipe(scene_recipe(arguments.scene, setup.scene.files, arguments.render)));
  const bool stopped = interrupted() && done < 1.0;
  if (stopped) image.metadata["vernier:stopped_at"] = std::to_string(std::lround(done * 100.0)) + " %";
  write_image(arguments.output, image, display);
  if (!arguments.quiet && !stopped) {
    std::fprintf(stderr, "%s: %dx%d, %u spp, double precision\n", arguments.output.c_str(), settings.width,
                 settings.height, settings.spp);
  }
  if (stopped) {
    throw Error(ErrorKind::failed, arguments.output + ": interrupted; it holds what was done by then");
  }
  return 0;
}

}  // namespace

void add_reference_command(CLI::App& app, Command& chosen) {
  const auto arguments = std::make_shared<ReferenceArguments>();
  CLI::App& command = *app.add_subcommand("reference", "Renders in double precision on the CPU: slow, the arbiter.");
  add_scene_argument(command, arguments->scene.scene, true);
  command.add_option("-o,--output", arguments->output, "image file: .exr (all layers), .png, .jpg, .hdr or .tif")
      ->type_name("FILE")
      ->required();
  add_size_option(command, arguments->render.size);
  add_sampling_options(command, arguments->render);
  add_filter_options(command, arguments->render);
  command
      .add_option("--exposure", arguments->exposure,
                  "stops added to .png and .jpg, -100 to 100; the others stay linear (default: 0)")
      ->type_name("EV");
  command.add_option("--threads", arguments->threads, "threads, up to 1024; 0 is one per core (default: 0)")
      ->type_name("N");
  command.add_flag("--quiet", arguments->quiet, "no progress and no summary; warnings stay (default: off)");
  add_scene_options(command, arguments->scene);
  command.footer("Example: vernier reference scenes/every_effect.glb -o truth.exr --size 320x180 --spp 4");
  command.callback([arguments, &chosen] { chosen = [arguments] { return run_reference(*arguments); }; });
}

}  // namespace vernier
