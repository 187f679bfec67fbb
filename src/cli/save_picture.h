#pragma once

#include "cli/render_command.h"
#include "preview/viewer.h"

namespace vernier {

/// `arguments` of the window with what was changed in it since: scene, camera, settings, exposure, and `picture`'s file
/// as the output. What was not changed keeps its text.
RenderCommandArguments render_arguments(const RenderCommandArguments& arguments, const SavedPicture& picture);

/// Writes `picture` as the file that `vernier render` writes by render_arguments, metadata and all. Throws Error(usage)
/// for an unknown extension and for a file that the scene was read from, Error(failed) where it cannot be written.
void save_picture(const RenderCommandArguments& arguments, const SavedPicture& picture);

}  // namespace vernier
