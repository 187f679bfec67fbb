// Blinn's highlight, stable at any exponent.
#ifndef VERNIER_BLINN_GLSL
#define VERNIER_BLINN_GLSL

#include "rounding.glsl"

// log(1 - s) for s in [0, 1), without the cancellation of 1 - s for small s: -2 atanh(z) with z = s / (2 - s).
float log_one_minus(IN(float) s) {
  if (s >= 0.25f) return log(1.0f - s);
  // z <= 1/7 here: the next term, z^13 / 13, is below 2^-40 of the first.
  float z = s / (2.0f - s);
  float q = z * z;
  return -2.0f * z *
         (1.0f + q * (1.0f / 3.0f + q * (1.0f / 5.0f + q * (1.0f / 7.0f + q * (1.0f / 9.0f + q * (1.0f / 11.0f))))));
}

// max(N.H, 0)^exponent, H the unit half vector of two unit vectors (Blinn 1977, "Models of Light Reflection for Computer
// Synthesized Pictures"). N.H = 1 - |N - H|^2 / 2 keeps the digits that decide at large exponents.
// 1 at exponent 0 above the horizon; 0 where N.H <= 0 or the half vector vanishes.
float blinn_highlight(IN(vec3) normal, IN(vec3) to_light, IN(vec3) to_viewer, IN(float) exponent) {
  vec3 half_vector = unit_vector(to_light + to_viewer);
  if (dot_product(normal, half_vector) <= 0.0f) return 0.0f;
  if (exponent == 0.0f) return 1.0f;
  if (level_at(SPOT_SPECULAR) == LEVEL_FAST) return pow(dot_product(normal, half_vector), exponent);
  vec3 difference = normal - half_vector;
  float s = min(0.5f * dot_product(difference, difference), 1.0f - HALF_ULP_OF_ONE);
  const float log2_e = 1.44269504088896340736f;
  return exp2(exponent * log_one_minus(s) * log2_e);
}

#endif
