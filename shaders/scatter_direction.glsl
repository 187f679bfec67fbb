// Directions of mirrored and refracted rays. shaders/README.md, Image formation 5.5 and 5.6.
#ifndef VERNIER_SCATTER_DIRECTION_GLSL
#define VERNIER_SCATTER_DIRECTION_GLSL

#include "fresnel.glsl"

// The normal about which rays are mirrored and refracted: `normal`, or mirrored at the plane across `to_viewer` where it
// faces away from the viewer, as interpolated normals do near silhouettes. Continuous there.
vec3 scatter_normal(IN(vec3) normal, IN(vec3) to_viewer) {
  float cosine = dot_product(normal, to_viewer);
  return cosine < 0.0f ? unit_vector(normal - to_viewer * (2.0f * cosine)) : normal;
}

// `direction` brought to the side of the unit vector `side` by mirroring at its plane, where it is not there yet.
vec3 kept_on_side(IN(vec3) direction, IN(vec3) side) {
  float height = dot_product(direction, side);
  return height < 0.0f ? direction - side * (2.0f * height) : direction;
}

// Mirror direction of `to_viewer` about `normal`, kept above the surface. Unit.
vec3 mirrored_direction(IN(vec3) to_viewer, IN(vec3) normal, IN(vec3) geometric_normal) {
  vec3 direction = normal * (2.0f * dot_product(normal, to_viewer)) - to_viewer;
  return unit_vector(kept_on_side(direction, geometric_normal));
}

// Snell's direction with every step in numbers of twice the precision, and for vectors that are unit to a rounding alone: with
// C = n.v / n.n and r = v.v / n.n the direction -v - n k / (c + g) becomes -v - n k r / (C + sqrt(k r + C^2)). Next to the
// critical angle the root magnifies what a float's cosine has lost.
vec3 exact_refracted_direction(IN(vec3) to_viewer, IN(vec3) normal, IN(float) eta) {
  WideVector v = widened_vector(to_viewer);
  WideVector n = widened_vector(normal);
  DoubleFloat normal_squared = wide_dot_product(n, n);
  DoubleFloat cosine = wide_quotient(wide_dot_product(n, v), normal_squared);
  DoubleFloat k = wide_product(two_difference(eta, 1.0f), two_sum(eta, 1.0f));
  DoubleFloat scaled_k = wide_product(k, wide_quotient(wide_dot_product(v, v), normal_squared));
  DoubleFloat g_squared = wide_sum(scaled_k, wide_product(cosine, cosine));
  // At the critical angle itself fresnel_dielectric(), which knows the rounded cosine, may see light pass.
  DoubleFloat g = widened(0.0f);
  if (g_squared.hi > 0.0f) g = wide_square_root(g_squared);
  DoubleFloat bend = wide_quotient(scaled_k, wide_sum(cosine, g));
  return -narrowed_unit_vector(WideVector(wide_sum(v.x, wide_product(n.x, bend)), wide_sum(v.y, wide_product(n.y, bend)),
                                          wide_sum(v.z, wide_product(n.z, bend))));
}

// Snell's direction behind the surface for index ratio eta, with `fresnel` of the same: exactly -to_viewer at eta = 1.
// (-v - n k / (c + g)) / eta, where k / (c + g) = g - c without its cancellation. Kept below the surface. Unit.
vec3 refracted_direction(IN(vec3) to_viewer, IN(vec3) normal, IN(vec3) geometric_normal, IN(float) eta,
                         IN(Fresnel) fresnel) {
  if (eta == 1.0f) return -to_viewer;
  if (level_at(SPOT_FRESNEL) == LEVEL_EXACT) {
    vec3 exact = exact_refracted_direction(to_viewer, normal, eta);
    vec3 kept = kept_on_side(exact, -geometric_normal);
    return kept == exact ? exact : unit_vector(kept);
  }
  float cosine = dot_product(normal, to_viewer);
  precise float k = (eta - 1.0f) * (eta + 1.0f);
  vec3 direction = (-to_viewer - normal * (k / (cosine + fresnel.refracted_cosine))) / eta;
  return unit_vector(kept_on_side(direction, -geometric_normal));
}

#endif
