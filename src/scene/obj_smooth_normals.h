#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <unordered_map>

#include "scene/parse_obj.h"

namespace vernier {

/// Normals of smoothing groups, by smooth_normal_key: sums of the normals of the adjacent triangles of the group,
/// weighed by their angle at the vertex (Thuermer and Wuethrich 1998, Computing Vertex Normals from Polygonal Facets),
/// so that the cut of polygons into triangles does not show. Unit; (0, 0, 0) where they cancel. Holds the vertices of
/// triangles in a group of which a corner has no normal of its own.
using SmoothNormals = std::unordered_map<std::uint64_t, glm::dvec3>;

/// Key of vertex `position` in smoothing group `group`.
inline std::uint64_t smooth_normal_key(int position, std::uint32_t group) {
  return static_cast<std::uint64_t>(static_cast<std::uint32_t>(position)) << 32 | group;
}

/// Smooth normals of `geometry`. Triangles without area or with a non-finite corner add nothing.
SmoothNormals smooth_normals(const ObjGeometry& geometry);

}  // namespace vernier
