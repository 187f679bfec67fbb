#include "reference/baked_triangles.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vernier::reference {

namespace {

InstanceFrame frame_of(const Instance& instance) {
  const glm::dmat3 linear(instance.world_from_object);
  return {glm::transpose(glm::inverse(linear)), linear, glm::determinant(linear) < 0.0 ? -1.0 : 1.0};
}

glm::dvec3 unit_normal(const std::array<glm::dvec3, 3>& corners) {
  const glm::dvec3 cross = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
  // Scaled first: the square of a small triangle's cross product may underflow.
  const double largest = std::max({std::abs(cross.x), std::abs(cross.y), std::abs(cross.z)});
  return largest > 0.0 ? glm::normalize(cross / largest) : glm::dvec3(0.0);
}

Triangle bake_triangle(const Mesh& mesh, const Instance& instance, bool mirrored, std::uint32_t primitive) {
  Triangle triangle;
  triangle.vertices = mesh.triangles[primitive];
  if (mirrored) std::swap(triangle.vertices[1], triangle.vertices[2]);
  for (int corner = 0; corner < 3; ++corner) {
    const glm::dvec3 position(mesh.positions[triangle.vertices[corner]]);
    triangle.corners[corner] = glm::dvec3(instance.world_from_object * glm::dvec4(position, 1.0));
  }
  triangle.normal = unit_normal(triangle.corners);
  triangle.primitive = primitive;
  triangle.material = mesh.triangle_materials[primitive];
  return triangle;
}

}  // namespace

BakedTriangles bake_triangles(const Scene& scene) {
  BakedTriangles baked;
  for (std::uint32_t index = 0; index < scene.instances.size(); ++index) {
    const Instance& instance = scene.instances[index];
    const Mesh& mesh = scene.meshes[instance.mesh];
    baked.frames.push_back(frame_of(instance));
    for (std::uint32_t primitive = 0; primitive < mesh.triangles.size(); ++primitive) {
      baked.triangles.push_back(bake_triangle(mesh, instance, baked.frames.back().handedness < 0.0, primitive));
      baked.triangles.back().instance = index;
    }
  }
  for (const Triangle& triangle : baked.triangles)
    for (const glm::dvec3& corner : triangle.corners)
      for (int axis = 0; axis < 3; ++axis)
        baked.largest_coordinate = std::max(baked.largest_coordinate, std::abs(corner[axis]));
  return baked;
}

}  // namespace vernier::reference
