#pragma once

#include <functional>
#include <string>

#include "preview/view_session.h"

namespace vernier {

/// What a window is opened with.
struct ViewPlan {
  std::string source;       ///< of the first scene, as load_scene takes it
  RenderSettings settings;  ///< of the picture
  std::string device;       ///< as `--device`
  float exposure_ev = 0.0f;
  /// Loads a scene for a picture of `aspect` = width / height; what is wrong with it is thrown as Error.
  std::function<ViewedScene(const std::string& source, double aspect)> load_scene;
  std::function<bool()> interrupted;  ///< true: close the window
};

/// Shows the scene in a window until it is closed. Throws Error: refused for a first scene that is broken (a later one
/// is told of in the window), no_device, device_lost, failed without a display.
void view_scene(const ViewPlan& plan);

}  // namespace vernier
