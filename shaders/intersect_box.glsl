// The slab test of a ray against the four quantised child boxes of a BVH node.
#ifndef VERNIER_INTERSECT_BOX_GLSL
#define VERNIER_INTERSECT_BOX_GLSL

#include "ray.glsl"
#include "shared/bvh_record.h"

// What the slab tests need of a ray.
struct SlabRay {
  vec3 origin;
  int largest;      // axis of the largest component of the direction
  vec3 inverse;     // 1 / direction, components at most 2^80 in size, the sign bit that of the direction
  vec3 bound;       // in a coarse BVH, by which planes are moved outwards
  bvec3 backwards;  // sign bit of the direction: the far plane is the lower one
};

// Roundings between the exact t of a box plane and the computed one: origin difference, reciprocal (up to 2.5 ulp on a
// Vulkan device, 5 half ulps), product, sum: 8. Ize 2013, "Robust BVH Ray Traversal", JCGT 2(2), with the terms of the grid.
// And those that move a corner sideways in the ray's frame (intersect_triangle.glsl), where a ray counts as a hit although it
// passes beside the triangle: 2 of the corner's own distance and 8 of its depth along the largest axis, in units of t.
const float SLAB_ROUNDINGS = 10.0f;

const int SLAB_MISS = 0x7fffffff;

// 1 / d without infinities. Fast: as it comes.
float bounded_reciprocal(IN(float) d) {
  if (level_at(SPOT_BOX) == LEVEL_FAST) return 1.0f / d;
  const float zero_fix = 1e-18f;  // what Embree puts in place of 0: the sign is lost, and 0 inf no longer stops the ray
  if (mutated(MUTATION_ZERO_DIRECTION)) return 1.0f / (d == 0.0f ? zero_fix : d);
  return bounded_inverse(d);
}

// Sizes that the planes of a coarse BVH have between them, in [-1, 1] and the cells of grids that reach beyond: 1 of a grid's origin
// and 2 of what is added to it, with some to spare.
const float COARSE_REACH = 4.0f;

// How far planes are moved outwards for the roundings of their t, which is summed up from sizes that are `reach` together.
vec3 slab_bound(IN(vec3) reach, IN(int) largest) {
  if (level_at(SPOT_BOX) == LEVEL_FAST) return vec3(0.0f);
  return (reach + vec3(axis_of(reach, largest))) * gamma_bound(SLAB_ROUNDINGS);
}

// `ray` prepared for slab tests.
SlabRay slab_ray(IN(Ray) ray) {
  SlabRay slab;
  slab.origin = ray.origin;
  slab.largest = largest_axis(ray.direction);
  slab.inverse = vec3(bounded_reciprocal(ray.direction.x), bounded_reciprocal(ray.direction.y),
                      bounded_reciprocal(ray.direction.z));
  slab.backwards = bvec3(floatBitsToInt(slab.inverse.x) < 0, floatBitsToInt(slab.inverse.y) < 0,
                         floatBitsToInt(slab.inverse.z) < 0);
  slab.bound = slab_bound((abs(ray.origin) + vec3(COARSE_REACH)) * abs(slab.inverse), slab.largest);
  return slab;
}

// Planes of one axis as t = byte * cell + near (far): `cell` per quantisation step, near and far moved outwards by a
// bound of their error, which covers the cancellation between the grid origin and the bytes.
struct SlabAxis {
  float cell;
  float near;
  float far;
};

SlabAxis slab_axis(IN(float) start, IN(float) cell, IN(float) bound) { return SlabAxis(cell, start - bound, start + bound); }

float byte_of(IN(uint) word, IN(uint) slot) { return float((word >> (8u * slot)) & 255u); }

// Where the ray enters child `slot` as the bits of t (order-preserving for t >= 0) with the slot number in the two lowest
// bits, or SLAB_MISS. Integers compare faster than floats and see no NaN. t_min and t_max are bits of floats >= 0.
int child_entry(IN(uint) slot, IN(uint) child_count, IN(SlabAxis) x, IN(SlabAxis) y, IN(SlabAxis) z, IN(uvec3) near_bytes,
                IN(uvec3) far_bytes, IN(int) t_min, IN(int) t_max) {
  int near_x = floatBitsToInt(byte_of(near_bytes.x, slot) * x.cell + x.near);
  int near_y = floatBitsToInt(byte_of(near_bytes.y, slot) * y.cell + y.near);
  int near_z = floatBitsToInt(byte_of(near_bytes.z, slot) * z.cell + z.near);
  int far_x = floatBitsToInt(byte_of(far_bytes.x, slot) * x.cell + x.far);
  int far_y = floatBitsToInt(byte_of(far_bytes.y, slot) * y.cell + y.far);
  int far_z = floatBitsToInt(byte_of(far_bytes.z, slot) * z.cell + z.far);
  int entry = max(max(near_x, near_y), max(near_z, t_min));
  int leave = min(min(far_x, far_y), min(far_z, t_max));
  return entry <= leave && slot < child_count ? (entry & ~3) | int(slot) : SLAB_MISS;
}

// Entries of the four children of the node in texels a, b, c, nearest first.
ivec4 intersect_children(IN(SlabRay) ray, IN(uvec4) a, IN(uvec4) b, IN(uvec4) c, IN(float) t_min, IN(float) t_max) {
  vec3 start = (uintBitsToFloat(uvec3(a.x, a.y, a.z)) - ray.origin) * ray.inverse;
  vec3 cell = uintBitsToFloat(uvec3((a.w << 23) & 0x7f800000u, (a.w << 15) & 0x7f800000u, (a.w << 7) & 0x7f800000u)) * ray.inverse;
  vec3 bound = ray.bound;
  if (!COARSE) bound = slab_bound(abs(start) + 255.0f * abs(cell), ray.largest);
  SlabAxis x = slab_axis(start.x, cell.x, bound.x);
  SlabAxis y = slab_axis(start.y, cell.y, bound.y);
  SlabAxis z = slab_axis(start.z, cell.z, bound.z);
  uvec3 near_bytes = uvec3(ray.backwards.x ? b.y : b.x, ray.backwards.y ? b.w : b.z, ray.backwards.z ? c.y : c.x);
  uvec3 far_bytes = uvec3(ray.backwards.x ? b.x : b.y, ray.backwards.y ? b.z : b.w, ray.backwards.z ? c.x : c.y);
  int t_lo = floatBitsToInt(t_min);
  int t_hi = floatBitsToInt(t_max);
  int e0 = child_entry(0u, c.w, x, y, z, near_bytes, far_bytes, t_lo, t_hi);
  int e1 = child_entry(1u, c.w, x, y, z, near_bytes, far_bytes, t_lo, t_hi);
  int e2 = child_entry(2u, c.w, x, y, z, near_bytes, far_bytes, t_lo, t_hi);
  int e3 = child_entry(3u, c.w, x, y, z, near_bytes, far_bytes, t_lo, t_hi);
  // Sorting network for four: (0,1) (2,3) (0,2) (1,3) (1,2).
  int lo01 = min(e0, e1);
  int hi01 = max(e0, e1);
  int lo23 = min(e2, e3);
  int hi23 = max(e2, e3);
  int first = min(lo01, lo23);
  int middle_a = max(lo01, lo23);
  int middle_b = min(hi01, hi23);
  int last = max(hi01, hi23);
  return ivec4(first, min(middle_a, middle_b), max(middle_a, middle_b), last);
}

#endif
