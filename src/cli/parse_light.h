#pragma once

#include <string>

#include "scene/light.h"

namespace vernier {

/// The light that `--light` describes: `point:x,y,z:r,g,b`, position in metres and intensity in candela, or
/// `dir:x,y,z:r,g,b`, the way the light travels (any length but 0) and irradiance in lux.
/// Throws Error(usage) for anything else.
Light parse_light(const std::string& text);

}  // namespace vernier
