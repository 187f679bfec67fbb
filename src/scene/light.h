#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <string>

#include "shared/light_kinds.h"

namespace vernier {

enum class LightKind : std::uint32_t { point = LIGHT_POINT, spot = LIGHT_SPOT, directional = LIGHT_DIRECTIONAL };

/// A punctual light of KHR_lights_punctual.
struct Light {
  std::string name;
  LightKind kind = LightKind::point;
  glm::dvec3 position = glm::dvec3(0.0);                   ///< metres, world; unused by directional
  glm::dvec3 direction = glm::dvec3(0, 0, -1);             ///< unit, world, the way the light travels; unused by point
  glm::vec3 intensity = glm::vec3(1.0f);                   ///< colour times candela (point, spot) or lux (directional)
  double range = std::numeric_limits<double>::infinity();  ///< metres; the light fades to nothing there
  double inner_cone_angle = 0.0;                           ///< radians from the axis, spot: full intensity within
  double outer_cone_angle = 0.7853981633974483;            ///< radians from the axis, spot: none outside
};

}  // namespace vernier
