#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "reference/shading_frame.h"

namespace vernier::reference {

/// A light as a point sees it, without what stands between.
struct LightArrival {
  glm::dvec3 direction;   ///< unit, from the point to the light
  double distance = 0.0;  ///< metres, infinity for a directional light
  glm::dvec3 irradiance;  ///< lux at normal incidence
};

/// What `light` sends to `point`: "Image formation" section 5 item 4. None where it sends nothing, or the point is
/// where the light is.
std::optional<LightArrival> light_arrival(const Light& light, const glm::dvec3& point);

/// The share of light that gets from `origin` on triangle `source` over `distance` metres along `direction`:
/// section 5 item 8. Per channel, 0 behind anything opaque, 1 with nothing between.
glm::dvec3 transmittance(const TracedScene& scene, const Ray& ray, double distance, std::uint32_t source);

/// The share of `arrival` that gets to `hit`, which stands as `frame` says: section 5 item 4. 0 where its triangle
/// faces away and is not rounded off by vertex normals.
glm::dvec3 visibility(const TracedScene& scene, const Hit& hit, const ShadingFrame& frame, const LightArrival& arrival);

}  // namespace vernier::reference
