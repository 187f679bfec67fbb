#include "effects/light_reach.h"

#include <algorithm>

namespace vernier {
namespace {

WorldBounds mesh_box(const Mesh& mesh) {
  WorldBounds box;
  for (const glm::vec3& position : mesh.positions) grow(box, glm::dvec3(position));
  return box;
}

}  // namespace

WorldBounds world_box(const Scene& scene) {
  std::vector<WorldBounds> boxes;
  for (const Mesh& mesh : scene.meshes) boxes.push_back(mesh_box(mesh));
  WorldBounds world;
  for (const Instance& instance : scene.instances) {
    const WorldBounds& box = boxes[instance.mesh];
    if (scene.meshes[instance.mesh].triangles.empty()) continue;
    for (int corner = 0; corner < 8; ++corner) {
      const glm::dvec3 point((corner & 1) != 0 ? box.hi.x : box.lo.x, (corner & 2) != 0 ? box.hi.y : box.lo.y,
                             (corner & 4) != 0 ? box.hi.z : box.lo.z);
      grow(world, glm::dvec3(instance.world_from_object * glm::dvec4(point, 1.0)));
    }
  }
  return world;
}

bool light_reaches(const Light& light, const WorldBounds& box) {
  const glm::dvec3 beyond = glm::max(glm::max(box.lo - light.position, light.position - box.hi), glm::dvec3(0.0));
  // Floats of the traced space are off by 2^-24 of the scene's extent, a few times over: 2^-16 is far more.
  constexpr double kDoubt = 0x1p-16;
  const glm::dvec3 size = glm::max(glm::abs(box.lo), glm::abs(box.hi));
  const double extent = std::max({size.x, size.y, size.z, std::abs(light.position.x), std::abs(light.position.y),
                                  std::abs(light.position.z), light.range});
  // Written so that a NaN reaches.
  return !(glm::length(beyond) > light.range + kDoubt * extent);
}

}  // namespace vernier
