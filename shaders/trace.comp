#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require

#include "shared/glsl.h"
#include "specialization.glsl"
#include "buffers.glsl"
#include "traversal_stack.glsl"
#include "trace_pixel.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

void main() {
  if (gl_GlobalInvocationID.x >= dispatch.tile_width || gl_GlobalInvocationID.y >= dispatch.tile_height) return;
  trace_pixel(dispatch.tile_x + gl_GlobalInvocationID.x, dispatch.tile_y + gl_GlobalInvocationID.y,
              gl_GlobalInvocationID.y * dispatch.tile_width + gl_GlobalInvocationID.x);
}
