#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#ifdef RAY_QUERIES
#extension GL_EXT_ray_query : require
#endif

// Traces rays from a buffer with the functions that render: what `vernier verify` tests is what runs.

#include "shared/glsl.h"
#include "specialization.glsl"
#include "buffers.glsl"
#include "traversal_stack.glsl"
#include "shared/verify_rays.h"
#include "spawn_ray.glsl"
#include "search_scene.glsl"

layout(local_size_x = 64) in;
layout(constant_id = SPECIALIZATION_FUNCTION) const uint FUNCTION = VERIFY_CLOSEST;
layout(set = 0, binding = BINDING_QUERIES, scalar) readonly buffer Queries { RayQuery queries[]; };
layout(set = 0, binding = BINDING_ANSWERS, scalar) writeonly buffer Answers { RayAnswer answers[]; };

RayAnswer first_answer(const Found found) {
  return RayAnswer(found.hit.triangle, found.hit.t, found.is_opaque ? 1u : 0u,
                   found.finished ? 1u : 0u, found.nodes, found.triangles, 0u, 0u, NONE, 0.0, vec3(0.0), vec3(0.0), vec3(0.0));
}

// The search that goes on from `hit` along the query's outgoing direction, as trace_path.glsl and direct_light.glsl start it.
Search respawned_search(const RayQuery query, const Hit hit, inout RayAnswer answer) {
  TrianglePoint point = triangle_point(Ray(query.origin, query.direction), hit);
  SurfacePoint surface = surface_point(point, fetch_material(point.vertices.w), no_slot_texels(), query.direction);
  answer.t = point.t;
  answer.position = surface.position;
  answer.normal = surface.geometric_normal;
  answer.respawned = spawn_origin(surface, query.outgoing);
  return Search(Ray(answer.respawned, query.outgoing), 0.0, NONE, LARGEST_FLOAT, (query.flags & RAY_ANY_HIT) != 0u);
}

void main() {
  keep_constants();
  if (gl_GlobalInvocationID.x >= queries.length()) return;
  RayQuery query = queries[gl_GlobalInvocationID.x];
  Search search = Search(Ray(query.origin, query.direction), query.t_min, query.after_triangle, query.t_max,
                         (query.flags & RAY_ANY_HIT) != 0u);
  RayAnswer answer;
  uint previous = 0u;
  bool again = true;
  for (uint round = 0u; again && round < VERIFY_HIT_LIMIT; round++) {
    Found found = search_scene(search);
    if (round == 0u) answer = first_answer(found);
    answer.finished = found.finished ? answer.finished : 0u;
    again = found.finished && found.hit.triangle != NONE;
    if (again) {
      answer.hit_count++;
      answer.descents += found.hit.triangle < previous ? 1u : 0u;
      previous = found.hit.triangle;
    }
    if (FUNCTION == VERIFY_ALL_HITS) {
      search.t_min = found.hit.t;
      search.after_triangle = found.hit.triangle;
    } else if (FUNCTION == VERIFY_RESPAWN && round == 0u) {
      if (again) search = respawned_search(query, found.hit, answer);
    } else {
      answer.next_triangle = round == 0u ? NONE : found.hit.triangle;
      answer.next_t = round == 0u ? 0.0 : found.hit.t;
      again = false;
    }
  }
  answers[gl_GlobalInvocationID.x] = answer;
}
