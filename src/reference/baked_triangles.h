#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "scene/scene.h"

namespace vernier::reference {

/// One triangle in world space, in double, with the way back to its mesh.
struct Triangle {
  std::array<glm::dvec3, 3> corners;  ///< metres; counter-clockwise seen from the front
  glm::dvec3 normal;                  ///< unit, towards the front; (0, 0, 0) for a triangle of zero area
  glm::uvec3 vertices;                ///< the corners' indices in the mesh, in the order of `corners`
  std::uint32_t instance = 0;         ///< indexes Scene::instances
  std::uint32_t primitive = 0;        ///< indexes the mesh's triangles
  std::uint32_t material = 0;         ///< indexes Scene::materials
};

/// How an instance carries directions into the world.
struct InstanceFrame {
  glm::dmat3 world_from_normal;   ///< inverse transpose of the linear part
  glm::dmat3 world_from_tangent;  ///< the linear part
  double handedness = 1.0;        ///< -1 where the transform mirrors
};

/// All triangles of all instances, by global triangle number, and the instances' frames.
struct BakedTriangles {
  std::vector<Triangle> triangles;
  std::vector<InstanceFrame> frames;
  double largest_coordinate = 0.0;  ///< metres; the scale that rounding errors of positions are measured in
};

/// Brings `scene` into the world by "Image formation" section 3. `scene` has passed validate_scene; an empty one
/// gives empty vectors.
BakedTriangles bake_triangles(const Scene& scene);

}  // namespace vernier::reference
