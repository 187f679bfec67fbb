#pragma once

#include "effects/effect_set.h"
#include "scene/scene.h"

namespace vernier {

/// Effects that rendering `scene` through `camera` can make visible. May be too large, never too small: any superset
/// gives the same picture. Judged by value: a transmission of 0 is none, a light of intensity 0 is none, a material
/// no triangle uses asks for nothing. What is off says why by name where something in the file seems to ask for it.
/// Rays of a weight below `cutoff` are not traced. Pure; O(triangles + vertices + materials + lights + texels).
/// `scene` has passed validate_scene.
EffectSet detect_effects(const Scene& scene, const Camera& camera, int max_bounces, double cutoff = 0.0);

}  // namespace vernier
