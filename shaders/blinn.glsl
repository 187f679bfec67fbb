// Blinn's highlight, stable at any exponent.
#ifndef VERNIER_BLINN_GLSL
#define VERNIER_BLINN_GLSL

#include "exact_power.glsl"

// The half vector L + V of two unit vectors without rounding, not of unit length.
WideVector half_vector(IN(vec3) to_light, IN(vec3) to_viewer) {
  return WideVector(two_sum(to_light.x, to_viewer.x), two_sum(to_light.y, to_viewer.y), two_sum(to_light.z, to_viewer.z));
}

// The squared sine of the angle between `normal` and h, neither of them unit nor zero, by their cross product: right to a few
// roundings at any angle, where 1 - cosine^2 has no digits left for the small angles that large exponents ask for.
float squared_sine(IN(vec3) normal, IN(WideVector) h) {
  vec3 high = vec3(h.x.hi, h.y.hi, h.z.hi);
  vec3 cross = vec3(signed_difference_of_products(normal.y, high.z, normal.z, high.y),
                    signed_difference_of_products(normal.z, high.x, normal.x, high.z),
                    signed_difference_of_products(normal.x, high.y, normal.y, high.x)) +
               cross_product(normal, vec3(h.x.lo, h.y.lo, h.z.lo));
  return dot_product(cross, cross) / (dot_product(normal, normal) * dot_product(high, high));
}

// log(1 - s) for s in [0, 1/4), without the cancellation of 1 - s for small s: -2 atanh(z) with z = s / (2 - s).
float log_one_minus(IN(float) s) {
  // z <= 1/7: the next term, z^13 / 13, is below 2^-40 of the first.
  float z = s / (2.0f - s);
  float q = z * z;
  return -2.0f * z *
         (1.0f + q * (1.0f / 3.0f + q * (1.0f / 5.0f + q * (1.0f / 7.0f + q * (1.0f / 9.0f + q * (1.0f / 11.0f))))));
}

// The highlight with every step in numbers of twice the precision. `cosine` is above 0.
float exact_highlight(IN(vec3) normal, IN(WideVector) h, IN(float) exponent) {
  WideVector n = widened_vector(normal);
  WideVector cross = wide_cross_product(n, h);
  DoubleFloat s = wide_quotient(wide_dot_product(cross, cross), wide_product(wide_dot_product(n, n), wide_dot_product(h, h)));
  DoubleFloat log_of_square = s.hi < 0.25f ? wide_log_one_minus(s) : wide_log(wide_difference(widened(1.0f), s));
  return wide_exp(wide_product(widened(0.5f * exponent), log_of_square));
}

// max(N.H, 0)^exponent, H the unit half vector of two unit vectors (Blinn 1977, "Models of Light Reflection for Computer
// Synthesized Pictures"). 1 at exponent 0 above the horizon; 0 where N.H <= 0 or the half vector vanishes.
float blinn_highlight(IN(vec3) normal, IN(vec3) to_light, IN(vec3) to_viewer, IN(float) exponent) {
  vec3 unit_half = unit_vector(to_light + to_viewer);
  float cosine = dot_product(normal, unit_half);
  if (cosine <= 0.0f) return 0.0f;
  if (exponent == 0.0f) return 1.0f;
  if (level_at(SPOT_SPECULAR) == LEVEL_FAST) return pow(cosine, exponent);
  WideVector h = half_vector(to_light, to_viewer);
  if (level_at(SPOT_SPECULAR) == LEVEL_EXACT) return exact_highlight(normal, h, exponent);
  float s = squared_sine(normal, h);
  const float log2_e = 1.44269504088896340736f;
  // A cosine below 0.87 keeps its digits itself.
  float log2_cosine = s < 0.25f ? 0.5f * log2_e * log_one_minus(s) : log2(min(cosine, 1.0f));
  return exp2(exponent * log2_cosine);
}

#endif
