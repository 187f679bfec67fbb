#version 460
#extension GL_EXT_scalar_block_layout : require

// Keeps the device busy for `rounds` dependent steps (a linear congruential generator) and stores where it ended.
layout(local_size_x = 64) in;
layout(set = 0, binding = 0, scalar) buffer States { uint states[]; };
layout(push_constant, scalar) uniform Push { uint rounds; };

void main() {
  uint state = states[gl_GlobalInvocationID.x];
  for (uint i = 0u; i < rounds; ++i) state = state * MULTIPLIER + 1u;
  states[gl_GlobalInvocationID.x] = state;
}
