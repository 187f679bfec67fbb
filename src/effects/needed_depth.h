#pragma once

#include <span>

#include "effects/effect_set.h"
#include "effects/seen_materials.h"

namespace vernier {

/// How deep the ray tree of a picture with `effects` can be that shows the materials `seen`: no ray is reflected or
/// refracted more often before its weight falls below the cutoff. Never too small.
DepthNeed needed_depth(std::uint32_t effects, std::span<const SeenMaterial> seen, std::uint32_t max_bounces,
                       double cutoff);

}  // namespace vernier
