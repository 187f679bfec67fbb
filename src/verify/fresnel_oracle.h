#pragma once

#include <glm/glm.hpp>

namespace vernier {

/// Powers at the boundary of two dielectrics, unpolarised, in wide arithmetic.
struct ExactFresnel {
  bool total = false;  ///< nothing is transmitted
  long double reflected = 1.0L;
  long double transmitted = 0.0L;
};

/// Snell's law and the four amplitudes of Fresnel (Born and Wolf 1999, Principles of Optics, section 1.5.2, equations
/// 20 and 21) for `cosine` of incidence in [0, 1] and `eta` = index behind / in front > 0. The sign that decides on
/// total reflection is exact for floats with eta >= 0.1: both squares and eta^2 - 1 fit into 64 bits.
ExactFresnel exact_fresnel(float cosine, float eta);

/// eta^2 cos(theta_t)^2 = eta^2 - sin(theta_i)^2, of the sign that decides on total reflection.
long double exact_g_squared(float cosine, float eta);

/// A ray behind a boundary by Snell's law, in wide arithmetic.
struct ExactRefraction {
  bool total = false;                        ///< there is none; the rest is 0
  glm::vec<3, long double> direction{0.0L};  ///< unit
  long double cosine = 0.0L;                 ///< of incidence
  long double refracted_cosine = 0.0L;       ///< behind
};

/// For the vectors as they are but made unit, `to_viewer` on the side of `normal`, neither of them 0.
ExactRefraction exact_refraction(const glm::vec<3, long double>& to_viewer, const glm::vec<3, long double>& normal,
                                 long double eta);

/// How many times as large as an error of the cosine of incidence the refracted direction's is, at least: the cosine
/// moves g - c by (c - g) / g, that over eta is along the normal, and sin(theta_t) of it is across the direction.
long double refraction_condition(const ExactRefraction& refraction, long double eta);

}  // namespace vernier
