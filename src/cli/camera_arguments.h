#pragma once

#include "cli/scene_options.h"
#include "preview/camera_words.h"

namespace vernier {

/// `scene` seen through the camera that `words` say.
SceneArguments with_camera(SceneArguments scene, const CameraWords& words);

/// The words of the camera in `scene`.
CameraWords words_of(const SceneArguments& scene);

}  // namespace vernier
