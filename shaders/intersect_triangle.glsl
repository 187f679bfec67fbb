// Ray against triangle: the watertight test (Woop, Benthin, Wald 2013, "Watertight Ray/Triangle Intersection", JCGT 2(1));
// at the fast level that of Moeller and Trumbore, at the exact level with edge values of the right sign.
#ifndef VERNIER_INTERSECT_TRIANGLE_GLSL
#define VERNIER_INTERSECT_TRIANGLE_GLSL

#include "double_float.glsl"
#include "ray.glsl"

// The ray's own frame: axes permuted so that z is the largest component of the direction, and the shear that turns the
// ray into the z axis. The same for all triangles, so that a shared corner has the same bits in each of them.
struct ShearedRay {
  vec3 origin;
  vec3 direction;
  int largest;    // axis of the largest component
  vec3 shear;     // (dx / dz, dy / dz, 1 / dz)
  float nearest;  // corners nearer than that, in units of t, may lie behind by the rounding of the origin
  vec2 inverse;   // 1 / the two smaller components, bounded
  vec2 endless;   // added to where the ray leaves a slab: beyond all that is hit if it runs along it, else 0
};

// Where a ray crosses a triangle, before that is judged.
struct Crossing {
  bool inside;
  float t;
  bool in_front;  // of the origin, for certain
};

// Roundings between the origin meant and the one given.
const float ORIGIN_ROUNDINGS = 8.0f;
// Roundings of the side of a plane that the origin lies on.
const float SIDE_ROUNDINGS = 8.5f;
// Roundings that t may lie outside the bounds of its triangle, so that t stays as it is where the plane runs along an axis and
// its distance is worked out in two ways. Three more of a bound (difference, reciprocal, product), two where the slack is
// applied, four of a box's plane: 13 in all. A box is widened by SLAB_ROUNDINGS of the plane's distance and as many of the
// depth, both at least t: 20.
const float BOUNDS_ROUNDINGS = 4.0f;

// v with `axis` last, in cyclic order.
vec3 axis_last(IN(vec3) v, IN(int) axis) {
  return axis == 0 ? vec3(v.y, v.z, v.x) : axis == 1 ? vec3(v.z, v.x, v.y) : v;
}

// The frame of `ray`, whose direction is not zero.
ShearedRay sheared_ray(IN(Ray) ray) {
  ShearedRay frame;
  frame.origin = ray.origin;
  frame.direction = ray.direction;
  frame.largest = largest_axis(ray.direction);
  vec3 d = axis_last(ray.direction, frame.largest);
  frame.shear = vec3(d.x / d.z, d.y / d.z, 1.0f / d.z);
  frame.nearest = gamma_bound(ORIGIN_ROUNDINGS) * max3(abs(ray.origin)) * abs(frame.shear.z);
  frame.inverse = vec2(bounded_inverse(d.x), bounded_inverse(d.y));
  const float beyond = 0.5f * LARGEST_FLOAT;  // with its rounding outwards still a number
  frame.endless = vec2(abs(d.x) < LEAST_COMPONENT ? beyond : 0.0f, abs(d.y) < LEAST_COMPONENT ? beyond : 0.0f);
  return frame;
}

// A corner in the ray's frame: x and y sheared, z in units of t.
vec3 sheared_corner(IN(ShearedRay) ray, IN(vec3) corner) {
  precise vec3 p = axis_last(corner - ray.origin, ray.largest);
  precise vec3 q = vec3(p.x - ray.shear.x * p.z, p.y - ray.shear.y * p.z, ray.shear.z * p.z);
  return q;
}

// Where the ray passes a corner along the frame's first two axes, in units of t.
vec2 corner_passed(IN(ShearedRay) ray, IN(vec3) corner) {
  precise vec3 p = axis_last(corner - ray.origin, ray.largest);
  return vec2(p.x, p.y) * ray.inverse;
}

// A part of a ray, in units of t.
struct Stretch {
  float enter;
  float leave;
};

// The part of the ray within the bounds of v0 v1 v2, whose depths lie between `nearest` and `farthest`. A hit within it lies
// within every box around the triangle too. Were t that of the plane alone, which a ray along it knows badly, a box could be
// entered behind the hit in it: whether it is found would hang on what was found before, copies of a triangle would not be
// told by their numbers, and a search that goes on at the t of a hit would miss them.
Stretch stretch_in_bounds(IN(ShearedRay) ray, IN(vec3) v0, IN(vec3) v1, IN(vec3) v2, IN(float) nearest, IN(float) farthest) {
  vec2 c0 = corner_passed(ray, v0);
  vec2 c1 = corner_passed(ray, v1);
  vec2 c2 = corner_passed(ray, v2);
  float enter = larger(smaller(smaller(c0.x, c1.x), c2.x), smaller(smaller(c0.y, c1.y), c2.y));
  float leave = smaller(larger(larger(c0.x, c1.x), c2.x) + ray.endless.x, larger(larger(c0.y, c1.y), c2.y) + ray.endless.y);
  return Stretch(larger(enter * (1.0f - gamma_bound(BOUNDS_ROUNDINGS)), nearest),
                 smaller(leave * (1.0f + gamma_bound(BOUNDS_ROUNDINGS)), farthest));
}

// The crossing with a triangle's plane.
struct PlaneCrossing {
  float t;
  bool in_front;  // of the origin, for certain
};

// Where the ray crosses the plane of v0 v1 v2, within the bounds of the triangle. By the plane, not by
// the weights of the corners, since those of a sliver know little of its depth; v0 lies opposite the longest edge
// (src/bvh/corner_order.h), so that a needle's normal comes from its short edges.
// In front for certain is a crossing whose origin lies on that side of the plane by more than the error of the side (Shewchuk
// 1997, "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates", section 4.2, with the roundings
// of the edges: 4 for the normal, 1 for the corner, 3 for the dot product, half for the bound itself). Or one whose origin lies in
// the plane within that error, and before all corners, or `weighed_ahead`: the weights see the crossing more than half-way to
// the farthest corner. A ray along a triangle, aimed at its edge, would slip through a closed surface.
PlaneCrossing plane_crossing(IN(ShearedRay) ray, IN(vec3) v0, IN(vec3) v1, IN(vec3) v2, IN(float) nearest, IN(float) farthest,
                             IN(bool) weighed_ahead) {
  const float scale = 1.099511627776e12f;  // 2^40 keeps products of three small lengths above 2^-126
  precise vec3 p = v0 - ray.origin;
  precise vec3 e1 = (v1 - v0) * scale;
  precise vec3 e2 = v2 - v0;
  precise vec3 plus = vec3(e1.y * e2.z, e1.z * e2.x, e1.x * e2.y);
  precise vec3 minus = vec3(e1.z * e2.y, e1.x * e2.z, e1.y * e2.x);
  precise vec3 normal = plus - minus;
  float side = dot_product(normal, p);
  float approach = dot_product(normal, ray.direction);
  float ahead = approach < 0.0f ? -side : side;
  Stretch bounds = stretch_in_bounds(ray, v0, v1, v2, nearest, farthest);
  float t = larger(smaller(side / approach, bounds.leave), bounds.enter);
  float bound = gamma_bound(SIDE_ROUNDINGS) * dot_product(abs(plus) + abs(minus), abs(p));
  bool certain = mutated(MUTATION_NO_LOWER_BOUND) ? t > 0.0f : ahead > bound || (ahead >= -bound && (nearest > ray.nearest || weighed_ahead));
  return PlaneCrossing(t, certain);
}

// a b - c d as a compiler that contracts makes it, fma(a, b, -(c d)): one product is rounded, the other is not, so that the
// value of the neighbour, whose products are exchanged, is not the negation.
float contracted_difference(IN(float) a, IN(float) b, IN(float) c, IN(float) d) {
  DoubleFloat unrounded = two_product(a, b);
  precise float difference = (unrounded.hi - c * d) + unrounded.lo;
  return difference;
}

// Twice the signed areas that the ray's axis spans with the edges from p2 to p1, p0 to p2 and p1 to p0.
vec3 edge_values(IN(vec3) p0, IN(vec3) p1, IN(vec3) p2) {
  if (mutated(MUTATION_CONTRACTED_EDGE)) {
    return vec3(contracted_difference(p2.x, p1.y, p2.y, p1.x), contracted_difference(p0.x, p2.y, p0.y, p2.x),
                contracted_difference(p1.x, p0.y, p1.y, p0.x));
  }
  // Rounding is monotone: a rounded difference of rounded products never has the wrong sign, only a false zero.
  precise vec3 edges = vec3(p2.x * p1.y - p2.y * p1.x, p0.x * p2.y - p0.y * p2.x, p1.x * p0.y - p1.y * p0.x);
  return edges;
}

// Numbers with the signs of the edge values; 0 only where an edge value is 0. 2^40 keeps the low parts of products of
// coordinates down to 2^-90 in the range of floats.
vec3 edge_signs(IN(vec3) p0, IN(vec3) p1, IN(vec3) p2) {
  const float scale = 1.099511627776e12f;
  vec3 q0 = p0 * scale;
  vec3 q1 = p1 * scale;
  vec3 q2 = p2 * scale;
  return vec3(sign_of_difference(q2.x, q1.y, q2.y, q1.x), sign_of_difference(q0.x, q2.y, q0.y, q2.x),
              sign_of_difference(q1.x, q0.y, q1.y, q0.x));
}

// The sign of the edge value from p to q, where it is 0 as if the ray were shifted by (e, e^2) for an infinitely small e: the
// ray then passes beside every edge and corner, and of the triangles around one of them exactly one is hit.
float edge_side(IN(float) value, IN(vec3) p, IN(vec3) q) {
  return value != 0.0f ? value : p.y != q.y ? p.y - q.y : q.x - p.x;
}

// Neither all above 0 nor all below. By the bits, which compare faster: as an int they are above 0 where the float is, as a
// uint above those of -0 where it lies below.
bool spans_zero(IN(float) a, IN(float) b, IN(float) c) {
  int least_above = min(floatBitsToInt(a), min(floatBitsToInt(b), floatBitsToInt(c)));
  uint least_below = min(floatBitsToUint(a), min(floatBitsToUint(b), floatBitsToUint(c)));
  return least_above <= 0 && least_below <= 0x80000000u;
}

// None below 0 or none above. Sums with 0 make 0 of -0.
bool is_of_one_sign(IN(vec3) v) {
  precise vec3 sum = v + vec3(0.0f);
  ivec3 bits = floatBitsToInt(sum);
  return min(bits.x, min(bits.y, bits.z)) >= 0 || max(bits.x, max(bits.y, bits.z)) <= 0;
}

// Inside by the signs of the edge values. On an edge both triangles are hit, at the exact level one of them.
bool is_inside(IN(vec3) edges, IN(vec3) p0, IN(vec3) p1, IN(vec3) p2) {
  if (level_at(SPOT_TRIANGLE) == LEVEL_EXACT) {
    float u = edge_side(edges.x, p2, p1);
    float v = edge_side(edges.y, p0, p2);
    float w = edge_side(edges.z, p1, p0);
    return (u > 0.0f && v > 0.0f && w > 0.0f) || (u < 0.0f && v < 0.0f && w < 0.0f);
  }
  // Edge values of a tiny triangle far beside the ray are rounded to 0, and two such zeros would make it a hit.
  return spans_zero(p0.x, p1.x, p2.x) && spans_zero(p0.y, p1.y, p2.y) && is_of_one_sign(edges);
}

// The crossing by the watertight test. Every ray through a shared edge or corner of two triangles hits at least one of them:
// the corners shear to the same bits in both, and the neighbour's edge value is the exact negation.
Crossing watertight_crossing(IN(ShearedRay) ray, IN(vec3) v0, IN(vec3) v1, IN(vec3) v2) {
  vec3 p0 = sheared_corner(ray, v0);
  vec3 p1 = sheared_corner(ray, v1);
  vec3 p2 = sheared_corner(ray, v2);
  vec3 edges = level_at(SPOT_TRIANGLE) == LEVEL_EXACT ? edge_signs(p0, p1, p2) : edge_values(p0, p1, p2);
  precise float det = edges.x + edges.y + edges.z;
  float nearest = smaller(smaller(p0.z, p1.z), p2.z);
  float farthest = larger(larger(p0.z, p1.z), p2.z);
  precise float depth = edges.x * p0.z + edges.y * p1.z + edges.z * p2.z;
  bool weighed_ahead = (det < 0.0f ? -depth : depth) > 0.5f * farthest * abs(det);
  PlaneCrossing plane = plane_crossing(ray, v0, v1, v2, nearest, farthest, weighed_ahead);
  return Crossing(is_inside(edges, p0, p1, p2) && det != 0.0f, plane.t, plane.in_front);
}

// The crossing by the test of Moeller and Trumbore (1997, "Fast, Minimum Storage Ray-Triangle Intersection"): rays slip
// through shared edges. (t, weights of corners 1 and 2); no number where the ray runs along the plane.
vec3 plain_crossing(IN(Ray) ray, IN(vec3) v0, IN(vec3) v1, IN(vec3) v2) {
  vec3 e1 = v1 - v0;
  vec3 e2 = v2 - v0;
  vec3 p = cross_product(ray.direction, e2);
  float inverse_det = 1.0f / dot_product(e1, p);
  vec3 from_corner = ray.origin - v0;
  vec3 q = cross_product(from_corner, e1);
  return vec3(dot_product(e2, q), dot_product(from_corner, p), dot_product(ray.direction, q)) * inverse_det;
}

// The weights of corners 0, 1 and 2 where `ray`, which hits the triangle, crosses it. A search does without them.
vec3 crossing_weights(IN(Ray) ray, IN(vec3) v0, IN(vec3) v1, IN(vec3) v2) {
  if (level_at(SPOT_TRIANGLE) == LEVEL_FAST) {
    vec3 crossing = plain_crossing(ray, v0, v1, v2);
    return vec3(1.0f - crossing.y - crossing.z, crossing.y, crossing.z);
  }
  ShearedRay sheared = sheared_ray(ray);
  vec3 edges = edge_values(sheared_corner(sheared, v0), sheared_corner(sheared, v1), sheared_corner(sheared, v2));
  precise float det = edges.x + edges.y + edges.z;
  float b1 = edges.y / det;
  float b2 = edges.z / det;
  return vec3(1.0f - b1 - b2, b1, b2);
}

// Whether the ray crosses the triangle at (t, triangle) after (t_min, after_triangle) and before `hit`, in the order of
// hits; then `hit` is replaced. False for a miss, zero area or any NaN. after_triangle matters at t = t_min alone; NONE lets
// nothing at t_min itself pass. False, too, unless `asked`: corners of a record that is no triangle may be no numbers, and
// compilers may take it that there are none such.
bool intersect_if(IN(bool) asked, IN(ShearedRay) ray, IN(vec3) v0, IN(vec3) v1, IN(vec3) v2, IN(uint) triangle, IN(uint) record,
                  IN(float) t_min, IN(uint) after_triangle, INOUT(Hit) hit) {
  Crossing crossing;
  if (level_at(SPOT_TRIANGLE) == LEVEL_FAST) {
    vec3 plain = plain_crossing(Ray(ray.origin, ray.direction), v0, v1, v2);
    bool inside = plain.y >= 0.0f && plain.z >= 0.0f && plain.y + plain.z <= 1.0f;
    crossing = Crossing(inside, plain.x, plain.x > 0.0f);
  } else {
    crossing = watertight_crossing(ray, v0, v1, v2);
  }
  float t = crossing.t;
  bool tie_counts = t == t_min && !mutated(MUTATION_TIES_SKIPPED);
  bool after = t > t_min || (tie_counts && triangle > after_triangle && after_triangle != NONE);
  bool before = t < hit.t || (t == hit.t && triangle < hit.triangle);
  bool accepted = asked && crossing.inside && after && before && crossing.in_front;
  hit.t = accepted ? t : hit.t;
  hit.triangle = accepted ? triangle : hit.triangle;
  hit.record = accepted ? record : hit.record;
  return accepted;
}

// The same of what is a triangle.
bool intersect_triangle(IN(ShearedRay) ray, IN(vec3) v0, IN(vec3) v1, IN(vec3) v2, IN(uint) triangle, IN(uint) record,
                        IN(float) t_min, IN(uint) after_triangle, INOUT(Hit) hit) {
  return intersect_if(true, ray, v0, v1, v2, triangle, record, t_min, after_triangle, hit);
}

#endif
