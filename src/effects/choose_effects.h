#pragma once

#include <string>

#include "effects/effect_set.h"
#include "scene/scene.h"

namespace vernier {

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
