#pragma once

#include "cli/scene_options.h"
#include "scene/pending_images.h"
#include "scene/scene.h"

namespace vernier {

/// A scene in its light and the camera it is seen through.
struct SceneSetup {
  Scene scene;
  Camera camera;
  bool default_lights = false;  ///< they hang on the camera: neither file nor command line brings any
  double load_ms = 0.0;         ///< wall time of reading the files
};

/// The same while images are still being decoded.
struct LoadingSetup {
  SceneSetup setup;
  PendingImages images;
};

/// Opens the scene that `settings` name (the built-in one without a name), chooses the camera for an image of
/// `aspect` = width / height and sets the light. Throws Error(refused) for a broken file, Error(usage) for a camera
/// that is not there.
LoadingSetup open_setup(const SceneSettings& settings, double aspect);

/// Waits for the images of `loading`, which counts as loading, too. Throws as PendingImages::finish.
SceneSetup finish(LoadingSetup loading);

/// Both in one. Throws Error(refused) for a scene, too, that the host's memory cannot hold.
SceneSetup set_up_scene(const SceneSettings& settings, double aspect);

/// Puts the lights and the environment of `settings` in place of the file's and adds the default lighting that is
/// missing (add_default_lighting); a background that is given stays. Throws Error(refused) for a missing background
/// file; `images` will for a broken one.
void set_lighting(Scene& scene, PendingImages& images, const Camera& camera, const SceneSettings& settings);

}  // namespace vernier
