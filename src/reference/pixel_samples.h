#pragma once

#include <cstdint>

#include "reference/camera_rays.h"
#include "reference/render_reference.h"

namespace vernier::reference {

/// Throws Error(usage) where `settings` describe no image.
void check_settings(const ReferenceSettings& settings);

/// The primary ray of sample `sample` of pixel (x, y).
Ray sample_ray(const Camera& camera, const ReferenceSettings& settings, int x, int y, std::uint32_t sample);

}  // namespace vernier::reference
