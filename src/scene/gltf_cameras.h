#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "scene/gltf_document.h"

namespace vernier {

/// The cameras that `nodes` carry, ordered by their number in the file, then by node order. Named after the camera,
/// without a name after the node. The node's scale and shear are taken out: direction -Z is kept, +Y made orthogonal to
/// it. Aspect ratio, near and far plane are left alone, xmag too. A camera whose node squashes it flat is left out with
/// a warning. Throws Error(refused) for a field of view outside (0, pi), a magnification of 0 or an unknown type.
std::vector<Camera> gltf_cameras(GltfDocument& document, std::span<const int> nodes,
                                 std::span<const glm::dmat4> world_from_node);

}  // namespace vernier
