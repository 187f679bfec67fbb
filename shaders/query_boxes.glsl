// Closest and any hit of a ray with the scene by the driver's own tree over the boxes of its triangles
// (GL_EXT_ray_query): the driver says whose boxes are met, the triangles are tested here. Hits are those of traverse_bvh, bit
// for bit, since neither hangs on the order in which triangles are tested.
#ifndef VERNIER_QUERY_BOXES_GLSL
#define VERNIER_QUERY_BOXES_GLSL

#include "intersect_triangle.glsl"
#include "loop_limit.glsl"
#include "search.glsl"
#include "shared/bvh_record.h"

// The float above t, which is finite and not below 0.
float next_above(IN(float) t) { return uintBitsToFloat(min(floatBitsToUint(t) + 1u, floatBitsToUint(LARGEST_FLOAT))); }

// The answer to `search`; no hit for a ray that is not valid.
Found query_boxes(IN(Search) search) {
  Found found = Found(no_hit(search.t_max), false, true, 0u, 0u);
  if (!scene_has_triangles() || !is_valid_ray(search.ray)) return found;
  ShearedRay sheared = sheared_ray(search.ray);
  rayQueryEXT query;
  rayQueryInitializeEXT(query, box_tree, gl_RayFlagsNoneEXT, 0xffu, search.ray.origin, search.t_min, search.ray.direction, search.t_max);
  bool running = true;
  // Candidates are fewer than the limit, which compilers cannot know (loop_limit.glsl).
  for (uint i = 0u; running && i < LOOP_ROUND_LIMIT; i++) {
    running = rayQueryProceedEXT(query);
    if (running) {
      uint record = uint(rayQueryGetIntersectionPrimitiveIndexEXT(query, false));
      uint first = 3u * record;
      uvec4 a = load_record(first);
      uvec4 b = load_record(first + 1u);
      uvec4 c = load_record(first + 2u);
      bool accepted = intersect_triangle(sheared, uintBitsToFloat(uvec3(a.x, a.y, a.z)), uintBitsToFloat(uvec3(b.x, b.y, b.z)),
                                         uintBitsToFloat(uvec3(c.x, c.y, c.z)), c.w, record, search.t_min, search.after_triangle,
                                         found.hit);
      bool opaque = (a.w & BVH_TRIANGLE_NOT_OPAQUE) == 0u;
      found.triangles += COUNT_COST ? 1u : 0u;
      found.is_opaque = accepted ? opaque : found.is_opaque;
      // The driver may leave out what lies at the t that it is told or beyond, but a lower number at the same t comes first.
      if (accepted) rayQueryGenerateIntersectionEXT(query, min(next_above(found.hit.t), search.t_max));
      if (accepted && opaque && search.stop_at_opaque) {
        rayQueryTerminateEXT(query);
        running = false;
      }
    }
  }
  found.finished = !running;
  return found;
}

#endif
