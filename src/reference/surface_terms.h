#pragma once

#include <glm/glm.hpp>

#include "reference/baked_triangles.h"

namespace vernier::reference {

/// The terms that every workflow ends in at one point: "Image formation" section 4, whose letters are in brackets.
struct SurfaceTerms {
  glm::dvec3 base = glm::dvec3(0.0);            ///< the albedo: base, kd in workflow blinn
  glm::dvec3 diffuse = glm::dvec3(0.0);         ///< [kd]
  glm::dvec3 specular = glm::dvec3(0.0);        ///< [ks]
  double exponent = 0.0;                        ///< [e]
  bool cosine = true;                           ///< the highlight is weighed by the light's cosine
  glm::dvec3 ambient = glm::dvec3(0.0);         ///< [ka]
  glm::dvec3 mirror_normal = glm::dvec3(0.0);   ///< [r0]
  glm::dvec3 mirror_grazing = glm::dvec3(0.0);  ///< [r90]
  glm::dvec3 transmission = glm::dvec3(0.0);    ///< [kt]
  glm::dvec3 emission = glm::dvec3(0.0);        ///< [ke]
  double withheld_normal = 0.0;                 ///< [b0] of a transmissive surface: share that does not go through
  double withheld_grazing = 0.0;                ///< [b90]
  bool plain_mirror = false;  ///< workflow blinn without fresnel_reflection: no Fresnel on glass either
};

/// Share of the light of a transmissive surface with Fresnel terms that goes through, before `transmission` tints it,
/// where Fresnel's reflectance at a boundary of index `ior` is `reflectance`.
double passed_share(const SurfaceTerms& terms, double reflectance, double ior);

/// The terms of `triangle`'s material at the point of `weights`. Meaningless for an unlit material but for `base`,
/// and for `transmission`, which is 0 then.
SurfaceTerms surface_terms(const Scene& scene, const Triangle& triangle, const glm::dvec3& weights);

}  // namespace vernier::reference
