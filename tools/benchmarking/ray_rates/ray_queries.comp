#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_ray_query : require

// The same by the driver's own traversal.

#include "ray_words.glsl"

layout(local_size_x = RATED_GROUP) in;
layout(constant_id = RATED_ANY_HIT) const bool ANY_HIT = false;
layout(set = 0, binding = BINDING_RATED_SCENE) uniform accelerationStructureEXT scene;

void main() {
  uint i = gl_GlobalInvocationID.x;
  uvec4 start = load_ray(2u * i);
  uvec4 way = load_ray(2u * i + 1u);
  const uint flags = gl_RayFlagsOpaqueEXT | (ANY_HIT ? gl_RayFlagsTerminateOnFirstHitEXT : 0u);
  rayQueryEXT query;
  rayQueryInitializeEXT(query, scene, flags, 0xffu, uintBitsToFloat(start.xyz), 0.0, uintBitsToFloat(way.xyz), uintBitsToFloat(way.w));
  bool finished = !rayQueryProceedEXT(query);  // of opaque triangles alone nothing is left to be decided
  bool hit = rayQueryGetIntersectionTypeEXT(query, true) == gl_RayQueryCommittedIntersectionTriangleEXT;
  uint triangle = hit ? uint(rayQueryGetIntersectionPrimitiveIndexEXT(query, true)) : RATED_NOTHING;
  float t = hit ? rayQueryGetIntersectionTEXT(query, true) : uintBitsToFloat(way.w);
  store_answer(i, uvec4(triangle, floatBitsToUint(t), finished ? 1u : 0u, 0u));
}
