#pragma once

#include <string>

namespace vernier {

/// The image file of a render of `scene` for which -o was not given: NAME.png in the current folder for
/// FOLDER/NAME.EXT, vernier.png for the built-in scene (empty).
std::string default_image_path(const std::string& scene);

/// Finds out before the work whether `path` can be written at its end: an image extension (Error(usage) otherwise),
/// and a folder that exists and may be written (Error(failed) otherwise). An existing file is fine.
void check_image_output(const std::string& path);

/// The same for a file of any extension; an empty path (not asked for) is fine.
void check_text_output(const std::string& path);

}  // namespace vernier
