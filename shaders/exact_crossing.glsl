// The exact level's crossing of a ray with a triangle's plane: right to the last place however far the ray comes from.
#ifndef VERNIER_EXACT_CROSSING_GLSL
#define VERNIER_EXACT_CROSSING_GLSL

#include "double_float.glsl"
#include "ray.glsl"

struct ExactCrossing {
  float t;
  float b0, b1, b2;  // weights of the corners, in [0, 1]
  vec3 position;
};

DoubleFloat clamped_weight(IN(DoubleFloat) weight) {
  return weight.hi <= 0.0f ? widened(0.0f) : weight.hi >= 1.0f ? widened(1.0f) : weight;
}

// a s + b t.
WideVector wide_combination(IN(WideVector) a, IN(DoubleFloat) s, IN(WideVector) b, IN(DoubleFloat) t) {
  return WideVector(wide_sum(wide_product(a.x, s), wide_product(b.x, t)), wide_sum(wide_product(a.y, s), wide_product(b.y, t)),
                    wide_sum(wide_product(a.z, s), wide_product(b.z, t)));
}

// x 2^k, exactly.
DoubleFloat scaled(IN(DoubleFloat) x, IN(float) power_of_two) { return DoubleFloat(x.hi * power_of_two, x.lo * power_of_two); }

// 2^k that brings `size` near 1, for 2^-100 <= 2^k <= 2^100.
float scale_to_one(IN(float) size) {
  uint exponent = clamp(floatBitsToUint(size) >> 23, 27u, 227u);
  return uintBitsToFloat((254u - exponent) << 23);
}

// v 2^k, exactly.
WideVector scaled(IN(WideVector) v, IN(float) power_of_two) {
  return WideVector(scaled(v.x, power_of_two), scaled(v.y, power_of_two), scaled(v.z, power_of_two));
}

// Through the plane first and then, near the triangle, its weights: so the ray's length costs its own share of digits and no
// more. The triangle has area and `ray` hits it. Edges and direction are scaled to about 1, so that no product leaves the range
// of wide arithmetic while the origin is not 2^60 times the triangle's size away.
ExactCrossing exact_crossing(IN(Ray) ray, IN(vec3) v0, IN(vec3) v1, IN(vec3) v2) {
  float edge_scale = scale_to_one(max(max3(abs(v1 - v0)), max3(abs(v2 - v0))));
  float ray_scale = scale_to_one(max3(abs(ray.direction)));
  WideVector e1 = scaled(exact_difference(v1, v0), edge_scale);
  WideVector e2 = scaled(exact_difference(v2, v0), edge_scale);
  WideVector normal = wide_cross_product(e1, e2);
  WideVector direction = widened_vector(ray.direction * ray_scale);
  WideVector to_corner = scaled(exact_difference(v0, ray.origin), edge_scale);
  DoubleFloat t = wide_quotient(wide_dot_product(normal, to_corner), wide_dot_product(normal, direction));
  WideVector local = WideVector(wide_difference(wide_product(direction.x, t), to_corner.x),
                                wide_difference(wide_product(direction.y, t), to_corner.y),
                                wide_difference(wide_product(direction.z, t), to_corner.z));
  DoubleFloat area = wide_dot_product(normal, normal);
  DoubleFloat b1 = clamped_weight(wide_quotient(wide_dot_product(wide_cross_product(local, e2), normal), area));
  DoubleFloat b2 = clamped_weight(wide_quotient(wide_dot_product(wide_cross_product(e1, local), normal), area));
  DoubleFloat b0 = clamped_weight(wide_difference(wide_difference(widened(1.0f), b1), b2));
  WideVector offset = scaled(wide_combination(e1, b1, e2, b2), 1.0f / edge_scale);
  vec3 position = vec3(narrowed(wide_sum(widened(v0.x), offset.x)), narrowed(wide_sum(widened(v0.y), offset.y)),
                       narrowed(wide_sum(widened(v0.z), offset.z)));
  return ExactCrossing(narrowed(t) * (ray_scale / edge_scale), narrowed(b0), narrowed(b1), narrowed(b2), position);
}

#endif
