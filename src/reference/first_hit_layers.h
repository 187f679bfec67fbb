#pragma once

#include <vector>

#include "image/image.h"
#include "reference/camera_rays.h"
#include "reference/traced_scene.h"

namespace vernier::reference {

/// The layers of "Image formation" section 6 for width x height pixels, filled with what a miss has: depth, position,
/// normal, shading_normal, uv, albedo, object_id, material_id, primitive_id, in this order.
std::vector<Layer> missed_layers(int width, int height);

/// Writes what `ray` meets first into pixel number `pixel` (row by row) of `layers` made by missed_layers. Pixels are
/// independent of each other, so that threads may fill them at the same time.
void fill_layers(const TracedScene& scene, const Ray& ray, std::size_t pixel, std::vector<Layer>& layers);

}  // namespace vernier::reference
