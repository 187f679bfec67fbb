#include "reference/camera_rays.h"

#include <cmath>

namespace vernier::reference {

Ray camera_ray(const Camera& camera, int width, int height, glm::dvec2 position) {
  const glm::dvec3 right(camera.world_from_camera[0]);
  const glm::dvec3 up(camera.world_from_camera[1]);
  const glm::dvec3 back(camera.world_from_camera[2]);
  const glm::dvec3 eye(camera.world_from_camera[3]);
  const double nx = (2.0 * position.x / width - 1.0) * width / height;
  const double ny = 1.0 - 2.0 * position.y / height;
  if (camera.orthographic) return {eye + camera.half_height * (nx * right + ny * up), -back};
  const double slope = std::tan(camera.vertical_fov / 2.0);
  return {eye, glm::normalize(slope * (nx * right + ny * up) - back)};
}

}  // namespace vernier::reference
