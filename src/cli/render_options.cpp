#include "cli/render_options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <limits>
#include <sstream>

#include "cli/parse_values.h"
#include "effects/choose_effects.h"
#include "effects/effect_names.h"
#include "error.h"
#include "render/develop.h"
#include "render/setting_limits.h"

namespace vernier {
namespace {

constexpr double kMaxDispatch_ms = 60000.0;  // after twice as long a device counts as lost
constexpr double kLeastErrorTarget = 1e-6;   // near the rounding of the floats in the file
constexpr double kMostErrorTarget = 10.0;
constexpr double kMaxTimeLimit_s = 31536000.0;  // a year

std::vector<std::string> parse_aovs(const std::string& list) {
  std::vector<std::string> aovs;
  std::istringstream names(list.empty() ? list : list + ",");
  std::string name;
  while (std::getline(names, name, ',')) {
    if (std::ranges::find(aov_names(), name) == aov_names().end()) {
      std::string known;
      for (const std::string& aov : aov_names()) {
        known += (known.empty() ? "" : ", ") + aov;
      }
      throw Error(ErrorKind::usage, "--aov: there is no `" + name + "`; there are " + known);
    }
    if (std::ranges::find(aovs, name) != aovs.end()) {
      throw Error(ErrorKind::usage, "--aov: `" + name + "` is listed twice");
    }
    aovs.push_back(name);
  }
  return aovs;
}

/// The one of `choices` whose name is `text`. Throws Error(usage) with the names there are.
template <typename Choices>
auto parse_choice(const char* option, const std::string& text, const Choices& choices) {
  std::string names;
  for (std::size_t i = 0; i < choices.size(); ++i) {
    if (text == to_string(choices[i])) return choices[i];
    if (i > 0) names += i + 1 < choices.size() ? ", " : " or ";
    names += to_string(choices[i]);
  }
  throw Error(ErrorKind::usage, std::string(option) + ": `" + text + "` is not " + names);
}

void parse_choices(const RenderArguments& arguments, RenderSettings& settings) {
  settings.accuracy = parse_accuracy("--accuracy", arguments.accuracy);
  settings.pixel_filter = parse_choice("--filter", arguments.filter, kPixelFilters);
  settings.texture_filter = parse_choice("--texture-filter", arguments.texture_filter, kTextureFilters);
  settings.bvh = parse_choice("--bvh", arguments.bvh, kBuildMethods);
  settings.traversal = parse_traversal(arguments.traversal);
}

void check_crop(const RenderSettings& settings) {
  const PixelRect rect = image_area(settings);
  if (rect.x + rect.width > settings.width || rect.y + rect.height > settings.height) {
    throw Error(ErrorKind::usage, "--crop: it reaches beyond the image of " + std::to_string(settings.width) + "x" +
                                      std::to_string(settings.height) + " pixels");
  }
  if (std::int64_t{rect.width} * rect.height > kMaxPixels) {
    throw Error(ErrorKind::usage, std::string(settings.crop ? "--crop" : "--size") + ": more than " +
                                      std::to_string(kMaxPixels) + " pixels at once" +
                                      (settings.crop ? "" : "; vernier render makes it in parts, with --crop"));
  }
}

void parse_limits(const RenderArguments& arguments, RenderSettings& settings) {
  settings.dispatch_ms = parse_number_in("--dispatch-ms", arguments.dispatch_ms, 1.0, kMaxDispatch_ms);
  if (!arguments.tile.empty()) {
    settings.tile = parse_size("--tile", arguments.tile);
  }
  if (!arguments.error_target.empty()) {
    settings.error_target =
        parse_number_in("--error-target", arguments.error_target, kLeastErrorTarget, kMostErrorTarget);
  }
  if (!arguments.time_limit.empty()) {
    constexpr double kOneMillisecond_s = 0.001;
    settings.time_limit_s = parse_number_in("--time-limit", arguments.time_limit, kOneMillisecond_s, kMaxTimeLimit_s);
  }
}

}  // namespace

std::string spp_text(const RenderArguments& arguments) {
  if (!arguments.spp.empty()) return arguments.spp;
  return arguments.error_target.empty() ? "16" : std::to_string(kErrorTargetSpp);
}

void add_size_option(CLI::App& app, std::string& size) {
  add_size_option(app, size, size);
}

void add_size_option(CLI::App& app, std::string& size, const std::string& default_size) {
  const std::string largest = std::to_string(kMaxSide_px);
  app.add_option("--size", size, "pixels, each side from 1 to " + largest + " (default: " + default_size + ")")
      ->type_name("WxH");
}

void add_effects_option(CLI::App& app, std::string& effects) {
  app.add_option("--effects", effects,
                 "auto, all, or a list read from left to right such as auto,-shadows or shadows,reflection; one that "
                 "begins with a minus begins with auto (default: auto, what the scene calls for)")
      ->type_name("LIST");
}

void add_accuracy_option(CLI::App& app, std::string& accuracy) {
  app.add_option("--accuracy", accuracy,
                 "numeric level: fast (what most renderers do), robust (bounded errors) or exact (twice the precision) "
                 "(default: robust)")
      ->type_name("LEVEL");
}

void add_path_options(CLI::App& app, RenderArguments& arguments) {
  const std::string most = std::to_string(kMaxBounces);
  app.add_option("--max-bounces", arguments.max_bounces,
                 "depth of reflections and refractions, 0 to " + most + " (default: 8)")
      ->type_name("N");
  app.add_option("--cutoff", arguments.cutoff,
                 "a ray whose weight falls below W in [0, 1] is not traced; 0 never cuts (default: 1/1024)")
      ->type_name("W");
  app.add_option("--seed", arguments.seed, "number of the sample pattern, 0 to 4294967295 (default: 0)")
      ->type_name("N");
}

void add_sampling_options(CLI::App& app, RenderArguments& arguments, const std::string& default_spp) {
  app.add_option("--spp", arguments.spp, "samples per pixel; 1 samples the pixel centre (default: " + default_spp + ")")
      ->type_name("N");
  add_path_options(app, arguments);
}

void add_filter_options(CLI::App& app, RenderArguments& arguments) {
  app.add_option("--filter", arguments.filter,
                 "how a pixel weighs samples: box (those within it alike) or tent (two pixels wide, smoother edges) "
                 "(default: box)")
      ->type_name("FILTER");
  app.add_option("--texture-filter", arguments.texture_filter,
                 "how textures are looked up: file (as it says), nearest or linear (default: file)")
      ->type_name("FILTER");
}

void add_aov_option(CLI::App& app, std::string& aov) {
  app.add_option("--aov", aov,
                 "further layers: depth (metres), position (metres), normal, shading_normal, uv, albedo, object_id, "
                 "material_id, "
                 "primitive_id, sample_count, cost (per sample); EXR holds them all, other formats make NAME.AOV.EXT "
                 "(default: none)")
      ->type_name("LIST");
}

void add_bvh_option(CLI::App& app, std::string& bvh) {
  app.add_option("--bvh", bvh,
                 "how the tree of boxes is built: fast (Morton codes), default (surface areas, 16 bins) or quality "
                 "(then subtrees move); never changes a bit of the image, but of its layer cost (default: default)")
      ->type_name("METHOD");
}

void add_device_option(CLI::App& app, std::string& device) {
  app.add_option("--device", device, "index or part of the name, see vernier devices (default: the best)")
      ->type_name("INDEX|NAME");
}

void add_traversal_option(CLI::App& app, std::string& traversal) {
  app.add_option("--traversal", traversal,
                 "how rays read the scene and keep their stack: auto (texels-shifted on llvmpipe, else storage-array), "
                 "texels-shifted, texels-array, storage-shifted or storage-array; or ray-query: by the driver's own "
                 "tree, where it has ray queries; never changes a bit of the image (default: auto)")
      ->type_name("FORM");
}

Accuracy parse_accuracy(const char* option, const std::string& text) {
  return parse_choice(option, text, kAccuracies);
}

TraversalForm parse_traversal(const std::string& text) {
  return parse_choice("--traversal", text, kTraversalForms);
}

void add_dispatch_options(CLI::App& app, RenderArguments& arguments) {
  app.add_option("--tile", arguments.tile, "pixels of a submission; never changes a bit of the image (default: chosen)")
      ->type_name("WxH");
  app.add_option("--dispatch-ms", arguments.dispatch_ms,
                 "time budget of one submission, milliseconds, 1 to 60000 (default: 100)")
      ->type_name("N");
}

void add_render_options(CLI::App& app, RenderArguments& arguments) {
  add_size_option(app, arguments.size);
  app.add_option("--crop", arguments.crop,
                 "pixels of the full image; their bits equal those of the full render (default: the whole image)")
      ->type_name("X,Y,W,H");
  add_sampling_options(app, arguments,
                       "16; with --error-target the most of a pixel: " + std::to_string(kErrorTargetSpp));
  app.add_option("--sample-range", arguments.sample_range,
                 "samples A to B-1 of each pixel, for merging (default: 0:spp)")
      ->type_name("A:B");
  add_aov_option(app, arguments.aov);
  add_filter_options(app, arguments);
  add_accuracy_option(app, arguments.accuracy);
  add_effects_option(app, arguments.effects);
  // For tests: not in the help, and a pipeline of its own that is slower.
  app.add_flag("--count-effects", arguments.count_effects, "adds effect_runs and rays_by_depth to --json")->group("");
  add_bvh_option(app, arguments.bvh);
  add_dispatch_options(app, arguments);
  add_traversal_option(app, arguments.traversal);
  app.add_option("--time-limit", arguments.time_limit,
                 "stop after S seconds of tracing, 0.001 to 31536000, with the samples done by then (default: none)")
      ->type_name("S");
  app.add_option(
         "--error-target", arguments.error_target,
         "stop when sqrt(relMSE) of the linear colours (see vernier diff) lies below E with 95 % confidence, 1e-6 "
         "to 10; pixels get as many samples as they need (default: none)")
      ->type_name("E");
}

RenderSettings parse_render_settings(const RenderArguments& arguments) {
  constexpr std::uint32_t kAnySeed = std::numeric_limits<std::uint32_t>::max();
  RenderSettings settings;
  const glm::ivec2 size = parse_size("--size", arguments.size);
  settings.width = size.x;
  settings.height = size.y;
  if (!arguments.crop.empty()) {
    settings.crop = parse_rect("--crop", arguments.crop);
  }
  check_crop(settings);
  settings.spp = parse_count("--spp", spp_text(arguments), 1, kMaxSpp);
  settings.sample_end = settings.spp;
  if (!arguments.sample_range.empty()) {
    const SampleRange range = parse_sample_range("--sample-range", arguments.sample_range, settings.spp);
    settings.sample_begin = range.begin;
    settings.sample_end = range.end;
  }
  settings.max_bounces = parse_count("--max-bounces", arguments.max_bounces, 0, kMaxBounces);
  settings.cutoff = static_cast<float>(parse_number_in("--cutoff", arguments.cutoff, 0.0, 1.0));
  settings.seed = parse_count("--seed", arguments.seed, 0, kAnySeed);
  parse_choices(arguments, settings);
  choose_effects(no_effects(), arguments.effects);  // refuses unknown names before any work is done
  settings.effects = arguments.effects;
  settings.count_effects = arguments.count_effects;
  settings.aovs = parse_aovs(arguments.aov);
  parse_limits(arguments, settings);
  return settings;
}

}  // namespace vernier
