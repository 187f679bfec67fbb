#pragma once

#include <cstddef>
#include <glm/glm.hpp>

#include "reference/baked_triangles.h"

namespace vernier::reference {

/// The uv of set `set` at each corner of `triangle`; (0, 0) where the mesh has no such set.
std::array<glm::dvec2, 3> corner_uvs(const Scene& scene, const Triangle& triangle, std::size_t set);

/// The uv of set `set` at the point of `weights`.
glm::dvec2 uv_at(const Scene& scene, const Triangle& triangle, const glm::dvec3& weights, std::size_t set);

/// The vertex colour at the point of `weights`; (1, 1, 1, 1) where the mesh has none.
glm::dvec4 color_at(const Scene& scene, const Triangle& triangle, const glm::dvec3& weights);

/// The texture in `slot` (TEXTURE_SLOT_*) of the triangle's material at the point of `weights`; (1, 1, 1, 1) without
/// one.
glm::dvec4 texture_at(const Scene& scene, const Triangle& triangle, const glm::dvec3& weights, std::size_t slot);

/// The alpha of a hit, in [0, 1]: "Image formation" section 3, Alpha. 0 means that there is no hit.
double coverage(const Scene& scene, const Triangle& triangle, const glm::dvec3& weights);

}  // namespace vernier::reference
