// Reflection and transmission at the boundary of two dielectrics, in a form without cancellation.
#ifndef VERNIER_FRESNEL_GLSL
#define VERNIER_FRESNEL_GLSL

#include "double_float.glsl"

// Powers reflected and transmitted (unpolarised) and the cosine of refraction times eta.
struct Fresnel {
  float reflected;
  float transmitted;   // 1 - reflected, worked out apart: no cancellation where either is small
  float refracted_cosine;  // eta cos(theta_t) >= 0; 0 for total internal reflection
};

// The textbook's form, which cancels where eta is near 1 and at grazing incidence (Pharr, Jakob, Humphreys, Physically Based
// Rendering 4th ed., section 9.3.5).
Fresnel textbook_fresnel(IN(float) cosine, IN(float) eta) {
  float squared_sine = (1.0f - cosine * cosine) / (eta * eta);
  if (squared_sine >= 1.0f) return Fresnel(1.0f, 0.0f, 0.0f);
  float refracted = sqrt(1.0f - squared_sine);
  float parallel = (eta * cosine - refracted) / (eta * cosine + refracted);
  float across = (cosine - eta * refracted) / (cosine + eta * refracted);
  float reflected = 0.5f * (parallel * parallel + across * across);
  return Fresnel(reflected, 1.0f - reflected, eta * refracted);
}

// eta^2 - (1 - cosine^2), the square of g in fresnel_dielectric(), to a few u^2 however much of it cancels: the squares are
// kept exactly, and where taking 1 away from their sum cancels digits nothing is rounded (Sterbenz). Next to the critical
// angle R moves with g itself: a g^2 with the error of a rounding of 1 would move R by 1e-4.
DoubleFloat wide_g_squared(IN(float) cosine, IN(float) eta) {
  DoubleFloat eta_squared = two_product(eta, eta);
  DoubleFloat cosine_squared = two_product(cosine, cosine);
  DoubleFloat sum = two_sum(eta_squared.hi, cosine_squared.hi);
  DoubleFloat leading = wide_sum(two_difference(sum.hi, 1.0f), widened(sum.lo));
  return wide_sum(leading, two_sum(eta_squared.lo, cosine_squared.lo));
}

// The same as fresnel_dielectric() below with every step in numbers of twice the precision.
Fresnel exact_fresnel(IN(float) cosine, IN(float) eta) {
  DoubleFloat c = widened(cosine);
  DoubleFloat one = widened(1.0f);
  DoubleFloat eta_squared = two_product(eta, eta);
  DoubleFloat k = wide_product(two_difference(eta, 1.0f), two_sum(eta, 1.0f));
  DoubleFloat c_squared = two_product(cosine, cosine);
  DoubleFloat g_squared = wide_g_squared(cosine, eta);
  if (!(g_squared.hi > 0.0f)) return Fresnel(1.0f, 0.0f, 0.0f);
  DoubleFloat g = wide_square_root(g_squared);
  DoubleFloat p = wide_sum(c, g);
  DoubleFloat q = wide_sum(wide_product(eta_squared, c), g);
  DoubleFloat p_squared = wide_product(p, p);
  DoubleFloat q_squared = wide_product(q, q);
  DoubleFloat bracket = wide_difference(g_squared, wide_product(eta_squared, wide_difference(one, c_squared)));
  DoubleFloat r_s = wide_quotient(k, p_squared);
  DoubleFloat r_p = wide_quotient(wide_product(k, bracket), q_squared);
  DoubleFloat reflected = wide_sum(wide_product(r_s, r_s), wide_product(r_p, r_p));
  DoubleFloat both = wide_sum(wide_quotient(one, p_squared), wide_quotient(eta_squared, q_squared));
  DoubleFloat transmitted = wide_product(wide_product(c, g), both);
  return Fresnel(min(0.5f * narrowed(reflected), 1.0f), min(2.0f * narrowed(transmitted), 1.0f), narrowed(g));
}

// `cosine` of the angle of incidence in [0, 1], `eta` = index behind / index in front, > 0. With k = eta^2 - 1 and
// g = eta cos(theta_t) = sqrt(k + cosine^2), the amplitudes are r_s = -k / (c + g)^2 and
// r_p = k ((eta^2 + 1) c^2 - 1) / (eta^2 c + g)^2; both vanish exactly at eta = 1.
// (Born and Wolf, Principles of Optics, section 1.5.2, multiplied out.) Beyond the critical angle all is reflected.
// For eta < 1 the bracket of r_p is written g^2 - eta^2 (1 - c^2): its two terms are as small as q^2 there, so R + T keeps
// the bound of the robust level (tests/shader/fresnel_test.cpp), which the other form breaks from eta = 1/2.4 on downwards.
Fresnel fresnel_dielectric(IN(float) cosine, IN(float) eta) {
  if (eta == 1.0f) return Fresnel(0.0f, 1.0f, cosine);  // no boundary, at grazing incidence too
  if (level_at(SPOT_FRESNEL) == LEVEL_FAST) return textbook_fresnel(cosine, eta);
  if (level_at(SPOT_FRESNEL) == LEVEL_EXACT) return exact_fresnel(cosine, eta);
  float g_squared = narrowed(wide_g_squared(cosine, eta));
  if (!(g_squared > 0.0f)) return Fresnel(1.0f, 0.0f, 0.0f);
  precise float k = (eta - 1.0f) * (eta + 1.0f);
  float g = sqrt(g_squared);
  float eta_squared = eta * eta;
  float p = cosine + g;
  float q = eta_squared * cosine + g;
  float r_s = k / (p * p);
  float bracket = eta < 1.0f ? g_squared - eta_squared * ((1.0f - cosine) * (1.0f + cosine))
                             : (eta_squared + 1.0f) * cosine * cosine - 1.0f;
  float r_p = k * bracket / (q * q);
  float transmitted = 2.0f * cosine * g * (1.0f / (p * p) + eta_squared / (q * q));
  return Fresnel(min(0.5f * (r_s * r_s + r_p * r_p), 1.0f), min(transmitted, 1.0f), g);
}

// Reflectance at normal incidence of a dielectric: ((ior - 1) / (ior + 1))^2.
float dielectric_f0(IN(float) ior) {
  float r = (ior - 1.0f) / (ior + 1.0f);
  return r * r;
}

// Whether nothing goes through.
bool is_total(IN(Fresnel) fresnel) { return fresnel.reflected >= 1.0f && fresnel.transmitted == 0.0f; }

// What Fresnel's terms let through at normal incidence, to divide by: where the index is so large that the reflectance is rounded to
// 1, as much as that rounding may have taken, 2^-24.
float passed_at_normal(IN(float) ior) { return max(1.0f - dielectric_f0(ior), 5.9604644775390625e-8f); }

// A reflectance that is `normal` at normal incidence and `grazing` at grazing, between them as Fresnel's terms of index `ior` run;
// 1 where these reflect all.
vec3 boundary_reflectance(IN(Fresnel) fresnel, IN(float) ior, IN(vec3) normal, IN(vec3) grazing) {
  float share = (fresnel.reflected - dielectric_f0(ior)) / passed_at_normal(ior);
  return is_total(fresnel) ? vec3(1.0f) : max(normal + (grazing - normal) * share, vec3(0.0f));
}

// The rest to 1 of the same for one component, without cancellation where it is small.
float boundary_transmittance(IN(Fresnel) fresnel, IN(float) ior, IN(float) normal, IN(float) grazing) {
  float share = fresnel.transmitted / passed_at_normal(ior);
  return is_total(fresnel) ? 0.0f : clamp((1.0f - grazing) + (grazing - normal) * share, 0.0f, 1.0f);
}

// Schlick's weight of grazing incidence, (1 - cosine)^5 (Schlick 1994, "An Inexpensive BRDF Model", eq. 15).
float schlick_weight(IN(float) cosine) {
  float m = clamp(1.0f - cosine, 0.0f, 1.0f);
  return m * m * m * m * m;
}

#endif
