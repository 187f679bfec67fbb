#pragma once

#include <string>

#include "image/image.h"
#include "image/whole_file.h"
#include "preview/view_session.h"
#include "preview/widgets.h"

namespace vernier {

/// Writes `picture`, display code values [height][width][3] in [0, 1], as the file `path`, a .png or .jpg, whole or not
/// at all; its folder is made. Throws Error(failed).
void write_screenshot(const std::string& path, const Image& picture);

/// What tests are told of a window: {"places": {NAME: [x, y, width, height]}, "samples", "share",
/// "rendering", "settled", "message"}.
std::string places_json(const WidgetPlaces& places, const ViewSession& session, bool settled,
                        const std::string& message);

}  // namespace vernier
