#version 460
#extension GL_EXT_scalar_block_layout : require

// words of `to` from `from`: to[i] = from[i] * factor + addend, for i below count.
layout(local_size_x = 64) in;
layout(constant_id = 0) const uint FACTOR = 1u;
layout(constant_id = 3) const float ADDEND = 0.0;
layout(set = 0, binding = 0, scalar) readonly buffer From { uint from[]; };
layout(set = 0, binding = 4, scalar) writeonly buffer To { uint to[]; };
layout(push_constant, scalar) uniform Push { uint count; uint first; };

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i < count) to[first + i] = from[first + i] * FACTOR + uint(ADDEND);
}
