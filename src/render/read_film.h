#pragma once

#include "image/image.h"
#include "render/film.h"
#include "render/render_statistics.h"

namespace vernier {

/// The image that `film` holds as `settings` ask for it: the colour layer (name "") with R G B A, the AOVs in their
/// order and, where asked for, the sums. Without metadata. Puts what the pixels tell into `statistics`: those that are
/// not finite, and samples. Geometry AOVs have been traced. Waits. Throws Error(device_lost).
ImageFile read_film(const Device& device, const Film& film, const RenderSettings& settings,
                    RenderStatistics& statistics);

/// Whether `settings` ask for AOVs of what the centres of pixels see, which trace_aovs writes.
bool wants_geometry(const RenderSettings& settings);

}  // namespace vernier
