#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "scene/gltf_document.h"

namespace vernier {

/// The lights of KHR_lights_punctual that `nodes` carry, in node order. The node's scale changes neither intensity nor
/// range. A spot or directional light whose node squashes it flat is left out with a warning. Throws Error(refused) for
/// a light number out of range, an unknown type, a negative intensity or colour, or cone angles that are not 0 <= inner
/// < outer <= pi / 2.
std::vector<Light> gltf_lights(GltfDocument& document, std::span<const int> nodes,
                               std::span<const glm::dmat4> world_from_node);

}  // namespace vernier
