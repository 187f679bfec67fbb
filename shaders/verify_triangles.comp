#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require

// The triangle test without a BVH and the box test without a traversal: what traverse_bvh's answers are compared with.

#include "shared/glsl.h"
#include "specialization.glsl"
#include "shared/verify_rays.h"
#include "intersect_box.glsl"
#include "intersect_triangle.glsl"
#include "loop_limit.glsl"

layout(local_size_x = 64) in;
layout(constant_id = SPECIALIZATION_FUNCTION) const uint FUNCTION = VERIFY_TRIANGLES;
layout(set = 0, binding = BINDING_QUERIES, scalar) readonly buffer Queries { RayQuery queries[]; };
layout(set = 0, binding = BINDING_ANSWERS, scalar) writeonly buffer Answers { RayAnswer answers[]; };
layout(set = 0, binding = BINDING_CORNERS, scalar) readonly buffer Corners { uvec4 corners[]; };

// The ray against each triangle by itself. `finished` where the loop was not cut off.
RayAnswer test_triangles(const RayQuery query) {
  ShearedRay sheared = sheared_ray(Ray(query.origin, query.direction));
  Hit best = no_hit(query.t_max);
  uint hits = 0u;
  uint count = corners.length() / BVH_RECORD_TEXELS;
  uint tested = 0u;
  for (; tested < count && tested < LOOP_ROUND_LIMIT; tested++) {
    uvec4 a = corners[3u * tested];
    uvec4 b = corners[3u * tested + 1u];
    uvec4 c = corners[3u * tested + 2u];
    Hit hit = no_hit(query.t_max);
    bool accepted = intersect_triangle(sheared, uintBitsToFloat(a.xyz), uintBitsToFloat(b.xyz), uintBitsToFloat(c.xyz), c.w,
                                       tested, query.t_min, query.after_triangle, hit);
    hits += accepted ? 1u : 0u;
    if (accepted && (hit.t < best.t || (hit.t == best.t && hit.triangle < best.triangle))) best = hit;
  }
  return RayAnswer(best.triangle, best.t, 1u, tested == count ? 1u : 0u, 0u, tested, hits, 0u, NONE, 0.0,
                   vec3(0.0), vec3(0.0), vec3(0.0));
}

// The children of record 0 that the ray may enter: bits in hit_count.
RayAnswer test_boxes(const RayQuery query) {
  ivec4 entries = intersect_children(slab_ray(Ray(query.origin, query.direction)), corners[0], corners[1], corners[2],
                                     query.t_min, query.t_max);
  uint entered = 0u;
  for (int i = 0; i < 4; i++) entered |= entries[i] == SLAB_MISS ? 0u : 1u << uint(entries[i] & 3);
  return RayAnswer(NONE, 0.0, 0u, 1u, 1u, 0u, entered, 0u, NONE, 0.0, vec3(0.0), vec3(0.0), vec3(0.0));
}

void main() {
  if (gl_GlobalInvocationID.x >= queries.length()) return;
  RayQuery query = queries[gl_GlobalInvocationID.x];
  answers[gl_GlobalInvocationID.x] = FUNCTION == VERIFY_BOXES ? test_boxes(query) : test_triangles(query);
}
