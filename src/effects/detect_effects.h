#pragma once

#include <string>

#include "effects/effect_set.h"
#include "scene/scene.h"

namespace vernier {

/// Effects that rendering `scene` through `camera` can make visible. May be too large, never too small: any superset
/// gives the same picture. Judged by value: a transmission of 0 is none, a light of intensity 0 is none, a material
/// no triangle uses asks for nothing. What is off says why by name where something in the file seems to ask for it.
/// Rays of a weight below `cutoff` are not traced. Pure; O(triangles + vertices + materials + lights + texels).
/// `scene` has passed validate_scene.
EffectSet detect_effects(const Scene& scene, const Camera& camera, int max_bounces, double cutoff = 0.0);

/// Applies the `--effects` option to what was detected: `auto`, `all`, or a list such as `auto,-shadows` or
/// `shadows,reflection` read from left to right. Effects another one needs are added and taken with it
/// (tinted_shadows needs shadows, absorption needs refraction, spot_lights need point_lights).
/// What is not in `detected` may lead rays deeper than that needs: then, and for `all`, as many bounces are needed as
/// are allowed. Throws Error(usage) for an unknown name.
EffectSet choose_effects(const EffectSet& detected, const std::string& list);

/// The one plan of a render: what is detected, as `list` (the `--effects` option) changes it. What renders, explains or
/// reports reads this.
EffectSet plan_effects(const Scene& scene, const Camera& camera, std::uint32_t max_bounces, double cutoff,
                       const std::string& list);

}  // namespace vernier
