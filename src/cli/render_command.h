#pragma once

#include <string>
#include <vector>

#include "cli/output_file.h"
#include "cli/render_options.h"
#include "cli/scene_options.h"
#include "image/display_picture.h"
#include "render/checkpoint.h"
#include "render/render_settings.h"

namespace vernier {

/// The texts of all options of `vernier render`.
struct RenderCommandArguments {
  SceneArguments scene;
  RenderArguments render;
  std::string output;
  std::string device;
  std::string exposure = "0";
  std::string checkpoint;
  std::string checkpoint_seconds;
  std::string resume;
  std::string json_file;
  bool quiet = false;
  bool verbose = false;
};

/// RenderCommandArguments in values, checked; the texts are kept for the recipe.
struct RenderPlan {
  SceneArguments scene_arguments;
  RenderArguments render_arguments;
  SceneSettings scene;
  RenderSettings settings;
  DisplayTransform display;
  std::string exposure;    ///< as the user wrote it
  std::string device;      ///< selector of choose_device, empty: the best
  std::string output;      ///< image file
  std::string json_file;   ///< empty: none
  std::string checkpoint;  ///< film file that is written now and then; empty: none
  double checkpoint_interval_s = kCheckpointInterval_s;
  std::string resume;  ///< film file to go on from; empty: begin
  bool quiet = false;
  bool verbose = false;
};

/// Checks everything that can be checked before a scene is read or a device is opened. Throws Error(usage) for texts
/// that make no sense, Error(failed) where the files could not be written at the end.
RenderPlan plan_render(const RenderCommandArguments& arguments);

/// The files that `plan` writes, an empty path for those that it does not.
std::vector<NamedFile> output_files(const RenderPlan& plan);

}  // namespace vernier
