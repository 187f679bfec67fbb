#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#ifdef RAY_QUERIES
#extension GL_EXT_ray_query : require
#endif

#include "shared/glsl.h"
#include "specialization.glsl"
#include "buffers.glsl"
#include "traversal_stack.glsl"
#include "primary.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

void main() {
  keep_constants();
  if (gl_GlobalInvocationID.x >= dispatch_constants().tile_width || gl_GlobalInvocationID.y >= dispatch_constants().tile_height) return;
  DispatchConstants constants = dispatch_constants();
  uint x = constants.tile_x + gl_GlobalInvocationID.x;
  uint y = constants.tile_y + gl_GlobalInvocationID.y;
  trace_primary(vec2(float(x), float(y)) + 0.5, (y - constants.band_y) * constants.band_width + (x - constants.band_x));
}
