#pragma once

#include <glm/glm.hpp>

namespace vernier::reference {

/// Unpolarised Fresnel reflectance in [0, 1] of a dielectric for the cosine of incidence `cosine` in [0, 1] and
/// `eta` = index beyond / index before, > 0. 1 beyond the critical angle and at it, 0 for eta = 1.
double fresnel_reflectance(double cosine, double eta);

/// fresnel_reflectance at normal incidence, from either side of a boundary with an index of `ior` between.
double reflectance_at_normal(double ior);

/// How far Fresnel's `reflectance` at a boundary of `ior` lies from that at normal incidence to 1, its value at grazing
/// incidence and beyond the critical angle.
double grazing_share(double reflectance, double ior);

/// The unit direction that Snell's law gives light seen along -`view` behind a surface with unit `normal` on the
/// viewer's side. `eta` as above; not beyond the critical angle.
glm::dvec3 refracted_direction(const glm::dvec3& view, const glm::dvec3& normal, double eta);

}  // namespace vernier::reference
