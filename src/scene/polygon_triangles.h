#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace vernier {

/// Corners of a triangle as positions in the polygon's list of corners.
using PolygonTriangle = std::array<std::uint32_t, 3>;

/// Triangles of a simple polygon of n corners, convex or not, with its winding: appends n - 2 triangles to `triangles`
/// (none for n < 3). Convex quads are cut along the shorter diagonal, larger convex polygons as a fan, all others by
/// ear clipping in the plane of the Newell normal (Meisters 1975, Polygons Have Ears). Coincident corners, as in holes
/// joined by a bridge, are allowed. Self-intersecting, collinear and non-finite polygons also give n - 2 triangles, of
/// which some may overlap or have no area. O(n) for convex polygons, else O(n^2),
/// with a bound beyond which the rest of a polygon is cut unchecked.
void append_polygon_triangles(std::span<const glm::dvec3> corners, std::vector<PolygonTriangle>& triangles);

}  // namespace vernier
