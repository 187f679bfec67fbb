#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>

#include "reference/baked_triangles.h"
#include "reference/camera_rays.h"

namespace vernier::reference {

/// A triangle number that no triangle has.
inline constexpr std::uint32_t kNoTriangle = 0xffffffffu;

/// Where a ray crosses the plane of a triangle: t in metres, weights of the three corners, sum 1; all of them at
/// least 0 inside the triangle and on its edges.
struct Crossing {
  double t = 0.0;
  glm::dvec3 weights;
};

/// A ray with what its intersections need once: the axis of its largest direction component and the shear that
/// carries the ray onto that axis (Woop, Benthin, Wald 2013, Watertight Ray/Triangle Intersection, JCGT 2(1)).
class ShearedRay {
 public:
  /// `source` is the triangle that the ray starts on, kNoTriangle for none. `largest_coordinate` of the scene.
  ShearedRay(const Ray& ray, std::uint32_t source, double largest_coordinate);

  /// Where the ray crosses the plane of `triangle` (number `id`) at t > 0, inside it or not. None where the ray is
  /// parallel to the plane, starts on it, or leaves it behind. Starting on it means: on the source triangle, or so near
  /// to the plane that rounding of the point cannot tell, 2^-44 (256 ulps) of the largest coordinate. In exact
  /// arithmetic such a start has t = 0, which is no hit. A triangle of zero area is never crossed.
  std::optional<Crossing> plane_crossing(const Triangle& triangle, std::uint32_t id) const;

  /// plane_crossing inside the triangle, edges included. Along an edge that two triangles share both decide by the same
  /// rounded number, so no ray slips through.
  std::optional<Crossing> hit(const Triangle& triangle, std::uint32_t id) const;

  /// Hits nearer to each other than this, in metres, have the same t: what rounding can make of an exact tie.
  double tie_width() const { return rounding_; }

 private:
  Ray ray_;
  std::uint32_t source_;
  double rounding_;
  glm::ivec3 axes_;
  glm::dvec2 shear_;
};

}  // namespace vernier::reference
