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

}  // namespace vernier
