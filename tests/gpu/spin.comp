#version 460
#extension GL_EXT_scalar_block_layout : require

// Keeps the device busy for `rounds` times STEPS steps of a generator (Marsaglia 2003, Xorshift RNGs) that no compiler
// shortens. Llvmpipe ends a loop after 65535 rounds, so the work is in the rounds.
layout(local_size_x = 64) in;
layout(set = 0, binding = 0, scalar) buffer States { uint states[]; };
layout(push_constant, scalar) uniform Push { uint rounds; };

void main() {
  uint state = states[gl_GlobalInvocationID.x];
  for (uint i = 0u; i < rounds; ++i) {
    for (uint step = 0u; step < STEPS; ++step) {
      state ^= state << 13;
      state ^= state >> 17;
      state ^= state << 5;
    }
  }
  states[gl_GlobalInvocationID.x] = state;
}
