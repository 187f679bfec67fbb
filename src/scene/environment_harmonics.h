#pragma once

#include <array>
#include <glm/glm.hpp>

#include "scene/scene.h"

namespace vernier {

/// Coefficients c0..c8 of the cosine-weighted mean radiance (irradiance / pi) of the ambient source around the unit
/// normal (x, y, z), by order-2 spherical harmonics (Ramamoorthi and Hanrahan 2001, An Efficient Representation for
/// Irradiance Environment Maps), all constants folded in:
///   A(n) = c0 + c1 y + c2 z + c3 x + c4 xy + c5 yz + c6 (3z^2 - 1) + c7 xz + c8 (x^2 - y^2)
/// The source is the ambient override where there is one, else the environment's image times texture_scale, else its
/// gradient. Exact for constants and gradients; an image is constant over each texel and integrated exactly over it, in
/// double, O(texels). NaN and infinite texels count as 0. `scene` has passed validate_scene.
std::array<glm::vec3, 9> ambient_harmonics(const Scene& scene);

}  // namespace vernier
