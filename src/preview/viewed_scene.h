#pragma once

#include <string>

#include "preview/camera_words.h"
#include "render/pack_scene.h"
#include "scene/scene.h"

namespace vernier {

/// A scene in its light, packed for a device, and the camera it is first seen through.
struct ViewedScene {
  std::string source;  ///< as the user named it; empty: the built-in scene
  Scene scene;
  PackedScene packed;
  CameraWords words;
  Camera camera;               ///< that `words` say
  bool lights_follow = false;  ///< the scene brings no lights: those it is shown with hang on the camera
  double load_ms = 0.0;        ///< wall time of reading, checking and packing
};

}  // namespace vernier
