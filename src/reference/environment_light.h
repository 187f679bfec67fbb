#pragma once

#include <array>
#include <glm/glm.hpp>

#include "scene/scene.h"

namespace vernier::reference {

/// The environment of a scene, ready to be asked; refers to the scene, which must outlive it.
struct EnvironmentLight {
  const Scene* scene = nullptr;
  std::array<glm::dvec3, 9> harmonics{};  ///< of the image's radiance, bands 0 to 2; unused without an image
};

/// Prepares the environment of `scene`. For an image the radiance is integrated over the sphere numerically: midpoint
/// rule on at least 1024 x 512 cells in (u, v) that the bilinear filter has no kink inside of, error below 1e-5 of the
/// brightest texel.
EnvironmentLight prepare_environment(const Scene& scene);

/// Radiance that arrives from the unit direction `direction`: "Image formation" section 5.
glm::dvec3 environment_radiance(const Scene& scene, const glm::dvec3& direction);

/// A(n): the cosine-weighted mean of the ambient source around unit `normal`, never negative: section 5 item 3.
glm::dvec3 ambient_radiance(const EnvironmentLight& light, const glm::dvec3& normal);

}  // namespace vernier::reference
