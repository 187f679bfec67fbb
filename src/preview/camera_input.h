#pragma once

#include <optional>

#include "preview/orbit_view.h"

namespace vernier {

/// What mouse and keys did to the camera in this frame: left drag turns around the target, middle drag or left with
/// shift moves across, right drag and wheel go nearer and farther, W A S D Q E move. `picture_height`: pixels of the
/// picture in the window, whose left part is `picture_width` pixels wide. Nothing while a panel has mouse or keys.
std::optional<OrbitView> camera_input(const OrbitView& view, float picture_width, float picture_height);

}  // namespace vernier
