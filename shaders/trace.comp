#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#ifdef RAY_QUERIES
#extension GL_EXT_ray_query : require
#endif
#ifdef TAKES_JOBS_TOGETHER
#extension GL_KHR_shader_subgroup_ballot : require
#endif

#include "shared/glsl.h"
#include "specialization.glsl"
#include "buffers.glsl"
#include "traversal_stack.glsl"
#include "trace_jobs.glsl"

layout(local_size_x = 64) in;

void main() {
  keep_constants();
  trace_jobs(gl_GlobalInvocationID.x);
}
