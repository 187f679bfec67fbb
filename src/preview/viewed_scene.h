#pragma once

#include <string>

#include "render/pack_scene.h"
#include "scene/scene.h"

namespace vernier {

/// A camera as the options of the command line say it; empty: not given. What the window looks through is always made
/// from these, so that a picture's recipe has the camera to the last bit.
struct CameraWords {
  std::string camera;  ///< of the file, its name or index
  std::string eye, target, up;
  std::string fov;
  std::string view_height;  ///< of an orthographic camera

  bool operator==(const CameraWords&) const = default;
};

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
