#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require

// A search for each ray by the functions that render, and nothing else.

#include "shared/glsl.h"
#include "specialization.glsl"
#include "buffers.glsl"
#include "traversal_stack.glsl"
#include "ray_words.glsl"
#include "traverse_bvh.glsl"

layout(local_size_x = RATED_GROUP) in;

void main() {
  keep_constants();
  uint i = gl_GlobalInvocationID.x;
  uvec4 start = load_ray(2u * i);
  uvec4 way = load_ray(2u * i + 1u);
  Ray ray = Ray(uintBitsToFloat(start.xyz), uintBitsToFloat(way.xyz));
  Found found = traverse_bvh(Search(ray, 0.0, NONE, uintBitsToFloat(way.w), start.w != 0u));
  store_answer(i, uvec4(found.hit.triangle, floatBitsToUint(found.hit.t), found.finished ? 1u : 0u, found.nodes + found.triangles));
}
