#include "verify/fresnel_oracle.h"

#include <cmath>

namespace vernier {

long double exact_g_squared(float cosine, float eta) {
  const long double n = eta;
  const long double c = cosine;
  return (n * n - 1.0L) + c * c;
}

ExactFresnel exact_fresnel(float cosine, float eta) {
  const long double g_squared = exact_g_squared(cosine, eta);
  if (!(g_squared > 0.0L)) return {true, 1.0L, 0.0L};
  const long double n = eta;
  const long double ci = cosine;
  const long double ct = std::sqrt(g_squared) / n;
  const long double s = (ci - n * ct) / (ci + n * ct);
  const long double p = (n * ci - ct) / (n * ci + ct);
  const long double ts = 2.0L * ci / (ci + n * ct);
  const long double tp = 2.0L * ci / (n * ci + ct);
  // Power through a surface element grows with index and cosine. At ci = 0 nothing enters.
  const long double beam = ci > 0.0L ? n * ct / ci : 0.0L;
  return {false, (s * s + p * p) / 2.0L, beam * (ts * ts + tp * tp) / 2.0L};
}

ExactRefraction exact_refraction(const glm::vec<3, long double>& to_viewer, const glm::vec<3, long double>& normal,
                                 long double eta) {
  const glm::vec<3, long double> v = glm::normalize(to_viewer), n = glm::normalize(normal);
  const long double cosine = glm::dot(v, n);
  const glm::vec<3, long double> along = (n * cosine - v) / eta;
  const long double sine_squared = glm::dot(along, along);
  if (sine_squared >= 1.0L) return {true};
  const long double refracted_cosine = std::sqrt(1.0L - sine_squared);
  return {false, along - n * refracted_cosine, cosine, refracted_cosine};
}

long double refraction_condition(const ExactRefraction& refraction, long double eta) {
  const long double g = eta * refraction.refracted_cosine;
  const long double sine = std::sqrt(1.0L - refraction.refracted_cosine * refraction.refracted_cosine);
  return sine * std::abs(refraction.cosine - g) / (g * eta);
}

}  // namespace vernier
