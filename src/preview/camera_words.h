#pragma once

#include "preview/orbit_view.h"
#include "preview/viewed_scene.h"

namespace vernier {

/// The options that make `base`, a camera of the file or a framed one, stand and look as `view` does. Numbers have all
/// their digits; --up is left out where the camera stands upright.
CameraWords camera_words(const CameraWords& base, const OrbitView& view);

/// The shortest text that reads back as `value`.
std::string shortest_text(double value);
/// The same for float32.
std::string shortest_text(float value);

}  // namespace vernier
