#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require

#include "shared/glsl.h"
#include "specialization.glsl"
#include "buffers.glsl"
#include "accumulate_samples.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

void main() {
  keep_dispatch_constants();
  if (LISTED_PIXELS) {
    accumulate_listed(gl_WorkGroupID.x * gl_WorkGroupSize.x * gl_WorkGroupSize.y + gl_LocalInvocationIndex);
    return;
  }
  if (gl_GlobalInvocationID.x >= dispatch_constants().tile_width || gl_GlobalInvocationID.y >= dispatch_constants().tile_height) return;
  accumulate_samples(gl_GlobalInvocationID.x, gl_GlobalInvocationID.y, first_job_of(gl_GlobalInvocationID.x, gl_GlobalInvocationID.y));
}
