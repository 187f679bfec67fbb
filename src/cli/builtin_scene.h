#pragma once

#include "scene/load_scene.h"

namespace vernier {

/// The scene `vernier render` shows without a file: scenes/every_effect.glb, which is part of the program, in
/// a soft gradient environment of its own.
LoadingScene open_builtin_scene(const LoadOptions& options);

/// Name of the built-in scene in messages and reports.
inline constexpr const char* kBuiltinSceneName = "every_effect.glb";

}  // namespace vernier
