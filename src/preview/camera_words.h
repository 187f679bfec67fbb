#pragma once

#include <string>

#include "preview/orbit_view.h"

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

/// The options that make `base`, a camera of the file or a framed one, stand and look as `view` does. Numbers have all
/// their digits; --up is left out where the camera stands upright.
CameraWords camera_words(const CameraWords& base, const OrbitView& view);

/// The shortest text that reads back as `value`.
std::string shortest_text(double value);
/// The same for float32.
std::string shortest_text(float value);

}  // namespace vernier
