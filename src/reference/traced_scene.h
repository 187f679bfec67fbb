#pragma once

#include <optional>

#include "reference/box_tree.h"
#include "reference/environment_light.h"
#include "reference/intersection.h"

namespace vernier::reference {

/// A scene ready to be traced. Refers to the scene, which must outlive it.
struct TracedScene {
  const Scene* scene = nullptr;
  BakedTriangles baked;
  BoxTree tree;
  EnvironmentLight environment;
};

/// What a triangle of an instance takes in it: itself, its place in the order, and, of the tree with three triangles a
/// leaf and more, a node and a half while that grows.
inline constexpr std::uint64_t kTriangleBytes = sizeof(Triangle) + sizeof(std::uint32_t) + 3 * sizeof(BoxTreeNode) / 2;

/// Prepares `scene`, which has passed validate_scene.
TracedScene prepare_scene(const Scene& scene);

/// Where a ray met a triangle. coverage: the alpha by which the surface is weighed, in (0, 1].
struct Hit {
  std::uint32_t triangle = kNoTriangle;
  double t = 0.0;  ///< metres
  glm::dvec3 weights;
  double coverage = 1.0;
};

/// The nearest hit of `ray`, which starts on triangle `source` (kNoTriangle: on none); hits that alpha cuts out are
/// none. Among equal t the lowest triangle number.
std::optional<Hit> closest_hit(const TracedScene& scene, const Ray& ray, std::uint32_t source);

}  // namespace vernier::reference
