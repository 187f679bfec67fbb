#pragma once

#include "effects/material_terms.h"
#include "scene/scene.h"

namespace vernier {

/// What the weight of a ray is at most multiplied with where it is reflected by `material`: never too small, infinity
/// where no bound is known, as of glass, vertex colours and float textures. `terms` are those of `material`, which is
/// one of `scene`.
double largest_mirror_weight(const Scene& scene, const Material& material, const MaterialTerms& terms,
                             const MaterialUsage& usage);

}  // namespace vernier
