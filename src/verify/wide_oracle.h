#pragma once

#include <array>
#include <glm/glm.hpp>

#include "bvh/bvh.h"
#include "shared/verify_rays.h"

namespace vernier {

/// A ray's crossing with a triangle's plane, worked out with 113 bits of mantissa (float128): products of three float
/// coordinates are exact or nearly so, and what is rounded is far below a step of float32.
struct WideCrossing {
  bool inside = false;      ///< the ray's line crosses the triangle, its edges included
  double t = 0.0;           ///< of the crossing with the plane; NaN where the ray is parallel to it
  double nearest_edge = 0;  ///< least of the weights, each 0 on an edge: how far inside (negative: outside)
  double cosine = 0.0;      ///< of the angle between direction and normal, not below 0
};

/// The crossing of `query`'s ray with `triangle`. All coordinates are finite.
WideCrossing wide_crossing(const RayQuery& query, const BvhTriangle& triangle);

/// A corner that is no float, as a transform makes it.
using LongPoint = glm::vec<3, long double>;

/// The same with such corners.
WideCrossing wide_crossing(const RayQuery& query, const std::array<LongPoint, 3>& corners);

/// Normal of the triangle, unit, rounded to double at the end; zero for zero area.
glm::dvec3 wide_normal(const BvhTriangle& triangle);

}  // namespace vernier
