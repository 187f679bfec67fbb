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

// start + e1 b1 + e2 b2, rounded once.
float placed(IN(float) start, IN(DoubleFloat) e1, IN(DoubleFloat) b1, IN(DoubleFloat) e2, IN(DoubleFloat) b2) {
  return narrowed(wide_sum(widened(start), wide_sum(wide_product(e1, b1), wide_product(e2, b2))));
}

// Through the plane first and then, near the triangle, its weights: so the ray's length costs its own share of digits and no
// more. The triangle has area and `ray` hits it; corners and origin lie within 2^30 of each other, so that no product leaves
// the range of wide arithmetic.
ExactCrossing exact_crossing(IN(Ray) ray, IN(vec3) v0, IN(vec3) v1, IN(vec3) v2) {
  WideVector e1 = exact_difference(v1, v0);
  WideVector e2 = exact_difference(v2, v0);
  WideVector normal = wide_cross_product(e1, e2);
  WideVector direction = widened_vector(ray.direction);
  WideVector to_corner = exact_difference(v0, ray.origin);
  DoubleFloat t = wide_quotient(wide_dot_product(normal, to_corner), wide_dot_product(normal, direction));
  WideVector local = WideVector(wide_difference(wide_product(direction.x, t), to_corner.x),
                                wide_difference(wide_product(direction.y, t), to_corner.y),
                                wide_difference(wide_product(direction.z, t), to_corner.z));
  DoubleFloat area = wide_dot_product(normal, normal);
  DoubleFloat b1 = clamped_weight(wide_quotient(wide_dot_product(wide_cross_product(local, e2), normal), area));
  DoubleFloat b2 = clamped_weight(wide_quotient(wide_dot_product(wide_cross_product(e1, local), normal), area));
  DoubleFloat b0 = clamped_weight(wide_difference(wide_difference(widened(1.0f), b1), b2));
  vec3 position = vec3(placed(v0.x, e1.x, b1, e2.x, b2), placed(v0.y, e1.y, b1, e2.y, b2), placed(v0.z, e1.z, b1, e2.z, b2));
  return ExactCrossing(narrowed(t), narrowed(b0), narrowed(b1), narrowed(b2), position);
}

#endif
