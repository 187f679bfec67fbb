// Ray against triangle: the watertight test (Woop, Benthin, Wald 2013, "Watertight Ray/Triangle Intersection", JCGT 2(1));
// at the fast level that of Moeller and Trumbore, at the exact level with edge values of the right sign.
#ifndef VERNIER_INTERSECT_TRIANGLE_GLSL
#define VERNIER_INTERSECT_TRIANGLE_GLSL

#include "double_float.glsl"
#include "ray.glsl"

// The ray's own frame: axes permuted so that z is the largest component of the direction, and the shear that turns the
// ray into the z axis. The same for all triangles, so that a shared corner has the same bits in each of them. Where the ray
// runs against z the frame is left-handed: edge values and their sum change their sign together.
struct ShearedRay {
  vec3 origin;
  vec3 direction;
  int largest;    // axis of the largest component
  vec3 shear;     // (dx / dz, dy / dz, 1 / dz)
  float depth_per_t;  // |dz|: from z in units of t to units of space
  float near_depth;   // corners nearer than that may lie behind by the rounding of the origin
};

// Where a ray crosses a triangle, before that is judged.
struct Crossing {
  bool inside;
  float t;
  float b1, b2;  // weights of corners 1 and 2
  bool in_front;  // of the origin, for certain
};

// Roundings between a corner's exact place in the ray's frame and the computed one, and those of the origin.
const float CORNER_ROUNDINGS = 8.0f;

// v with `axis` last, in cyclic order.
vec3 axis_last(IN(vec3) v, IN(int) axis) {
  return axis == 0 ? vec3(v.y, v.z, v.x) : axis == 1 ? vec3(v.z, v.x, v.y) : v;
}

// The frame of `ray`, whose direction is not zero.
ShearedRay sheared_ray(IN(Ray) ray) {
  vec3 size = abs(ray.direction);
  ShearedRay frame;
  frame.origin = ray.origin;
  frame.direction = ray.direction;
  frame.largest = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
  vec3 d = axis_last(ray.direction, frame.largest);
  frame.shear = vec3(d.x / d.z, d.y / d.z, 1.0f / d.z);
  frame.depth_per_t = abs(d.z);
  frame.near_depth = gamma_bound(CORNER_ROUNDINGS) * max3(abs(ray.origin));
  return frame;
}

// A corner in the ray's frame: x and y sheared, z in units of t.
vec3 sheared_corner(IN(ShearedRay) ray, IN(vec3) corner) {
  precise vec3 p = axis_last(corner - ray.origin, ray.largest);
  precise vec3 q = vec3(p.x - ray.shear.x * p.z, p.y - ray.shear.y * p.z, ray.shear.z * p.z);
  return q;
}

// The largest |x| and |y| of three sheared corners.
float largest_size_across(IN(vec3) p0, IN(vec3) p1, IN(vec3) p2) {
  return max(max(max(abs(p0.x), abs(p0.y)), max(abs(p1.x), abs(p1.y))), max(abs(p2.x), abs(p2.y)));
}

// Whether a crossing inside the triangle at the computed t lies in front of the origin for certain.
// Either t exceeds the bound of its error (pbrt-v4's derivation in "Robust Triangle Intersections", Physically Based
// Rendering 4th ed., section 6.8.7; its x, y and z are in units of space) with the largest of all x and y of the corners,
// L, in place of each and 2 L^2 in place of each edge value, which costs half as much: nearer hits may lie behind the
// origin. Or all corners lie in front: the bound of a triangle seen edge-on may be as large as t itself, and a ray aimed at
// its edge would slip through a closed surface.
bool is_in_front(IN(ShearedRay) ray, IN(vec3) p0, IN(vec3) p1, IN(vec3) p2, IN(float) inverse_det, IN(float) t) {
  if (mutated(MUTATION_NO_LOWER_BOUND)) return t > 0.0f;
  float largest_xy = largest_size_across(p0, p1, p2);
  float largest_z = max(abs(p0.z), max(abs(p1.z), abs(p2.z)));
  float largest_depth = largest_z * ray.depth_per_t;
  float error_t = 3.0f * largest_z * abs(inverse_det) * largest_xy *
                  ((4.0f * gamma_bound(3.0f) + 2.0f * gamma_bound(2.0f) + 4.0f * gamma_bound(5.0f)) * largest_xy +
                   4.0f * gamma_bound(5.0f) * largest_depth);
  float nearest_depth = min(p0.z, min(p1.z, p2.z)) * ray.depth_per_t;
  float near_depth = ray.near_depth + gamma_bound(CORNER_ROUNDINGS) * (2.0f * largest_xy + largest_depth);
  return t > error_t || nearest_depth > near_depth;
}

// Twice the signed areas that the ray's axis spans with the edges from p2 to p1, p0 to p2 and p1 to p0.
vec3 edge_values(IN(vec3) p0, IN(vec3) p1, IN(vec3) p2) {
  if (level_at(SPOT_TRIANGLE) == LEVEL_EXACT) {
    return vec3(signed_difference_of_products(p2.x, p1.y, p2.y, p1.x), signed_difference_of_products(p0.x, p2.y, p0.y, p2.x),
                signed_difference_of_products(p1.x, p0.y, p1.y, p0.x));
  }
  // Rounding is monotone: a rounded difference of rounded products never has the wrong sign, only a false zero.
  precise vec3 edges = vec3(p2.x * p1.y - p2.y * p1.x, p0.x * p2.y - p0.y * p2.x, p1.x * p0.y - p1.y * p0.x);
  if (mutated(MUTATION_CONTRACTED_EDGE)) {
    DoubleFloat unrounded = two_product(p2.x, p1.y);
    precise float contracted = (unrounded.hi - p2.y * p1.x) + unrounded.lo;
    edges.x = contracted;
  }
  return edges;
}

// The sign of the edge value from p to q, where it is 0 as if the ray were shifted by (e, e^2) for an infinitely small e: the
// ray then passes beside every edge and corner, and of the triangles around one of them exactly one is hit.
float edge_side(IN(float) value, IN(vec3) p, IN(vec3) q) {
  return value != 0.0f ? value : p.y != q.y ? p.y - q.y : q.x - p.x;
}

// Inside by the signs of the edge values. On an edge both triangles are hit, at the exact level one of them.
bool is_inside(IN(vec3) edges, IN(vec3) p0, IN(vec3) p1, IN(vec3) p2) {
  if (level_at(SPOT_TRIANGLE) == LEVEL_EXACT) {
    float u = edge_side(edges.x, p2, p1);
    float v = edge_side(edges.y, p0, p2);
    float w = edge_side(edges.z, p1, p0);
    return (u > 0.0f && v > 0.0f && w > 0.0f) || (u < 0.0f && v < 0.0f && w < 0.0f);
  }
  return min(edges.x, min(edges.y, edges.z)) >= 0.0f || max(edges.x, max(edges.y, edges.z)) <= 0.0f;
}

// 2^k that brings `size` near 1, for 2^-60 <= 2^k <= 2^60: products of exact arithmetic then keep their low parts.
float scale_to_one(IN(float) size) {
  uint exponent = clamp(floatBitsToUint(size) >> 23, 67u, 187u);
  return uintBitsToFloat((254u - exponent) << 23);
}

// The crossing by the watertight test. Every ray through a shared edge or corner of two triangles hits at least one of them:
// the corners shear to the same bits in both, and the neighbour's edge value is the exact negation.
Crossing watertight_crossing(IN(ShearedRay) ray, IN(vec3) v0, IN(vec3) v1, IN(vec3) v2) {
  vec3 p0 = sheared_corner(ray, v0);
  vec3 p1 = sheared_corner(ray, v1);
  vec3 p2 = sheared_corner(ray, v2);
  float scale = level_at(SPOT_TRIANGLE) == LEVEL_EXACT ? scale_to_one(largest_size_across(p0, p1, p2)) : 1.0f;
  vec3 across = vec3(scale, scale, 1.0f);
  vec3 edges = edge_values(p0 * across, p1 * across, p2 * across);
  precise float det = edges.x + edges.y + edges.z;
  precise float inverse_det = 1.0f / det;
  precise float t = (edges.x * p0.z + edges.y * p1.z + edges.z * p2.z) * inverse_det;
  return Crossing(is_inside(edges, p0, p1, p2) && det != 0.0f, t, edges.y * inverse_det, edges.z * inverse_det,
                  is_in_front(ray, p0, p1, p2, inverse_det * scale * scale, t));
}

// The crossing by the test of Moeller and Trumbore (1997, "Fast, Minimum Storage Ray-Triangle Intersection"): rays slip
// through shared edges.
Crossing plain_crossing(IN(ShearedRay) ray, IN(vec3) v0, IN(vec3) v1, IN(vec3) v2) {
  vec3 e1 = v1 - v0;
  vec3 e2 = v2 - v0;
  vec3 p = cross_product(ray.direction, e2);
  float det = dot_product(e1, p);
  float inverse_det = 1.0f / det;
  vec3 from_corner = ray.origin - v0;
  float b1 = dot_product(from_corner, p) * inverse_det;
  vec3 q = cross_product(from_corner, e1);
  float b2 = dot_product(ray.direction, q) * inverse_det;
  float t = dot_product(e2, q) * inverse_det;
  return Crossing(det != 0.0f && b1 >= 0.0f && b2 >= 0.0f && b1 + b2 <= 1.0f, t, b1, b2, t > 0.0f);
}

// Whether the ray crosses the triangle at (t, triangle) after (t_min, after_triangle) and before `hit`, in the order of
// hits; then `hit` is replaced. False for a miss, zero area or any NaN. after_triangle matters at t = t_min alone; NONE lets
// nothing at t_min itself pass.
bool intersect_triangle(IN(ShearedRay) ray, IN(vec3) v0, IN(vec3) v1, IN(vec3) v2, IN(uint) triangle, IN(uint) record,
                        IN(float) t_min, IN(uint) after_triangle, INOUT(Hit) hit) {
  Crossing crossing;
  if (level_at(SPOT_TRIANGLE) == LEVEL_FAST) {
    crossing = plain_crossing(ray, v0, v1, v2);
  } else {
    crossing = watertight_crossing(ray, v0, v1, v2);
  }
  float t = crossing.t;
  bool after = t > t_min || (t == t_min && triangle > after_triangle && after_triangle != NONE);
  bool before = t < hit.t || (t == hit.t && triangle < hit.triangle);
  bool accepted = crossing.inside && after && before && crossing.in_front;
  hit.t = accepted ? t : hit.t;
  hit.triangle = accepted ? triangle : hit.triangle;
  hit.record = accepted ? record : hit.record;
  hit.b1 = accepted ? crossing.b1 : hit.b1;
  hit.b2 = accepted ? crossing.b2 : hit.b2;
  return accepted;
}

#endif
