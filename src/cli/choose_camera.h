#pragma once

#include "cli/scene_options.h"
#include "scene/scene.h"

namespace vernier {

/// The camera that `settings` ask for in an image of `aspect` = width / height: the file's that --camera names or
/// numbers (a name goes before a number), else its first, else one that frames the whole scene; then moved by --eye,
/// turned to --target and --up, widened to --fov or --view-height. --eye alone looks at the centre of the scene,
/// --target alone turns the camera where it stands, --up alone rolls it. Without --up a moved or turned camera has +Y
/// up, or -Z where it looks along Y. Throws Error(usage) for an unknown camera, eye = target, up along the line of
/// sight, --fov of an orthographic camera, --view-height of another.
Camera choose_camera(const Scene& scene, const SceneSettings& settings, double aspect);

}  // namespace vernier
