#pragma once

#include <span>

#include "effects/effect_set.h"
#include "effects/seen_materials.h"

namespace vernier {

/// What a picture with `effects` shows of the materials `seen` that no specialization constant switches, since nothing
/// would be saved: light_attenuation, double_sided, texture_transform; each with its reason.
std::vector<EffectReason> fixed_effects(const Scene& scene, const EffectSet& effects,
                                        std::span<const SeenMaterial> seen);

}  // namespace vernier
