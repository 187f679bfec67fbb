#pragma once

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

}  // namespace vernier
