#include "effects/light_reach.h"

#include <algorithm>

namespace vernier {
namespace {

void include(WorldBox& box, const glm::dvec3& point) {
  box.low = glm::min(box.low, point);
  box.high = glm::max(box.high, point);
}

WorldBox mesh_box(const Mesh& mesh) {
  WorldBox box;
  for (const glm::vec3& position : mesh.positions) include(box, glm::dvec3(position));
  return box;
}

}  // namespace

WorldBox world_box(const Scene& scene) {
  std::vector<WorldBox> boxes;
  for (const Mesh& mesh : scene.meshes) boxes.push_back(mesh_box(mesh));
  WorldBox world;
  for (const Instance& instance : scene.instances) {
    const WorldBox& box = boxes[instance.mesh];
    if (scene.meshes[instance.mesh].triangles.empty()) continue;
    for (int corner = 0; corner < 8; ++corner) {
      const glm::dvec3 point((corner & 1) != 0 ? box.high.x : box.low.x, (corner & 2) != 0 ? box.high.y : box.low.y,
                             (corner & 4) != 0 ? box.high.z : box.low.z);
      include(world, glm::dvec3(instance.world_from_object * glm::dvec4(point, 1.0)));
    }
  }
  return world;
}

bool light_reaches(const Light& light, const WorldBox& box) {
  const glm::dvec3 beyond = glm::max(glm::max(box.low - light.position, light.position - box.high), glm::dvec3(0.0));
  // Floats of the traced space are off by 2^-24 of the scene's extent, a few times over: 2^-16 is far more.
  constexpr double kDoubt = 0x1p-16;
  const glm::dvec3 size = glm::max(glm::abs(box.low), glm::abs(box.high));
  const double extent = std::max({size.x, size.y, size.z, std::abs(light.position.x), std::abs(light.position.y),
                                  std::abs(light.position.z), light.range});
  // Written so that a NaN reaches.
  return !(glm::length(beyond) > light.range + kDoubt * extent);
}

}  // namespace vernier
