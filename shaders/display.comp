#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require

#include "shared/glsl.h"
#include "specialization.glsl"
#include "buffers.glsl"
#include "display.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(push_constant, scalar) uniform DisplayBlock { DisplayConstants constants; };

void main() {
  uint x = gl_GlobalInvocationID.x;
  uint y = gl_GlobalInvocationID.y;
  if (x >= constants.width || y >= constants.height) return;
  vec3 value = displayed(constants, y * constants.row_pixels + x);
  store_display((constants.first_row + y) * constants.width + x, display_word(value));
}
