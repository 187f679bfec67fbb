#pragma once

#include <glm/glm.hpp>
#include <string>

namespace vernier {

/// A camera of the scene. It looks along -Z of its own frame with +Y up.
struct Camera {
  std::string name;
  bool orthographic = false;
  glm::dmat4 world_from_camera = glm::dmat4(1.0);  ///< rigid: orthonormal axes and a position
  double vertical_fov = 0.7853981633974483;        ///< radians, full angle, in (0, pi); perspective only
  double half_height = 1.0;                        ///< metres, > 0; orthographic only (glTF ymag)
};

}  // namespace vernier
