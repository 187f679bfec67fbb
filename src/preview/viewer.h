#pragma once

#include <functional>
#include <string>
#include <vector>

#include "gpu/device.h"
#include "image/image.h"
#include "preview/script.h"
#include "preview/viewed_scene.h"
#include "render/render_statistics.h"

namespace vernier {

/// A picture to be written, and all that decided it.
struct SavedPicture {
  std::string path;
  ImageFile image;              ///< without metadata
  RenderStatistics statistics;  ///< what the pixels tell
  const ViewedScene& viewed;
  CameraWords words;
  RenderSettings settings;
  float exposure_ev = 0.0f;
  const DeviceDescription& device;
};

/// What a window is opened with, and what it asks of its caller.
struct ViewPlan {
  std::string source;       ///< of the first scene, as load_scene takes it
  RenderSettings settings;  ///< of the picture
  CameraWords words;        ///< of the first camera
  std::string device;       ///< as `--device`
  float exposure_ev = 0.0f;
  std::string message;  ///< to show at first; empty: none
  /// Loads a scene for a picture of `aspect` = width / height; what is wrong with it is thrown as Error. Called on
  /// another thread, one call at a time.
  std::function<ViewedScene(const std::string& source, const CameraWords& words, double aspect)> load_scene;
  /// The camera that `words` say. Throws Error(usage).
  std::function<Camera(const Scene& scene, const CameraWords& words, double aspect)> camera_of;
  /// Writes a picture as `vernier render` does. Throws Error.
  std::function<void(const SavedPicture& picture)> save;
  std::function<bool()> interrupted;  ///< true: close the window
  std::vector<ScriptEvent> script;    ///< in place of the user; empty: none
  std::string record_folder;          ///< of the script's screenshots
  std::string places_file;            ///< where the widgets lie, for tests; empty: not told
};

/// Shows the scene in a window until it is closed. A device that is lost is opened anew, with the message in the
/// window. Throws Error: refused for a first scene that is broken (a later one is told of in the window), no_device,
/// device_lost for one that is lost again at once, failed without a display or after messages of the validation layer,
/// usage for a script whose events make no sense.
void view_scene(const ViewPlan& plan);

}  // namespace vernier
