#pragma once

#include <string>

#include "render/render_settings.h"

namespace CLI {
class App;
}

namespace vernier {

/// The texts of the options that say how an image is made, with the defaults of the command line.
struct RenderArguments {
  std::string size = "1280x720";
  std::string crop;
  std::string spp;  ///< empty: see spp_text()
  std::string sample_range;
  std::string max_bounces = "8";
  std::string cutoff = "1/1024";
  std::string accuracy = "robust";
  std::string effects = "auto";
  std::string filter = "box";
  std::string texture_filter = "file";
  std::string bvh = "default";
  std::string traversal = "auto";
  std::string tile;
  std::string dispatch_ms = "100";
  std::string time_limit;
  std::string error_target;
  std::string aov;
  bool count_effects = false;
  std::string seed = "0";
};

/// The samples per pixel that are meant: 16 where none are given, with an error target kErrorTargetSpp.
std::string spp_text(const RenderArguments& arguments);

/// Adds --size to `app`, with the default that `size` holds: what reference and explain share with render.
void add_size_option(CLI::App& app, std::string& size);

/// The same where the default is another: the help has `default_size` for it.
void add_size_option(CLI::App& app, std::string& size, const std::string& default_size);

/// Adds --spp, whose help says what its default is, --max-bounces, --cutoff and --seed.
void add_sampling_options(CLI::App& app, RenderArguments& arguments, const std::string& default_spp = "16");

/// The same without --spp.
void add_path_options(CLI::App& app, RenderArguments& arguments);

/// Adds --filter and --texture-filter, which render and reference share.
void add_filter_options(CLI::App& app, RenderArguments& arguments);

/// Adds --accuracy.
void add_accuracy_option(CLI::App& app, std::string& accuracy);

/// Adds --effects.
void add_effects_option(CLI::App& app, std::string& effects);

/// Adds --aov.
void add_aov_option(CLI::App& app, std::string& aov);

/// Adds --bvh.
void add_bvh_option(CLI::App& app, std::string& bvh);

/// Adds --device.
void add_device_option(CLI::App& app, std::string& device);

/// Adds --traversal.
void add_traversal_option(CLI::App& app, std::string& traversal);

/// The level that `option` says. Throws Error(usage) with the names there are.
Accuracy parse_accuracy(const char* option, const std::string& text);

/// The form that --traversal says. Throws Error(usage) with the names there are.
TraversalForm parse_traversal(const std::string& text);

/// Adds --tile and --dispatch-ms, which change no bit.
void add_dispatch_options(CLI::App& app, RenderArguments& arguments);

/// Adds all options of RenderArguments to `app`. `arguments` outlives the parse.
void add_render_options(CLI::App& app, RenderArguments& arguments);

/// Reads the texts and checks them against each other: the crop lies in the image, the sample range in spp, at most
/// kMaxPixels are rendered, effects and AOVs exist. Throws Error(usage) that names the option.
RenderSettings parse_render_settings(const RenderArguments& arguments);

}  // namespace vernier
