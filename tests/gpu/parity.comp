#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require

// The shipped functions on operands from a buffer (parity_answers.h).
layout(local_size_x = 64) in;
layout(set = 0, binding = 0, scalar) readonly buffer Operands { float operands[]; };
layout(set = 0, binding = 1, scalar) writeonly buffer Answers { uint answers[]; };

const uint OPERAND_COUNT = 16u;
const uint ANSWER_COUNT = 18u;

// film.glsl wants them; nothing here calls them.
uvec4 load_film(uint i) { return uvec4(0u); }
void store_film(uint i, uvec4 block) {}

#include "shared/glsl.h"
#include "specialization.glsl"
#include "blinn.glsl"
#include "film.glsl"
#include "fresnel.glsl"
#include "intersect_triangle.glsl"
#include "sample_pattern.glsl"

uint next;
float number(uint i) { return operands[gl_GlobalInvocationID.x * OPERAND_COUNT + i]; }
void put(uint word) { answers[gl_GlobalInvocationID.x * ANSWER_COUNT + next++] = word; }

void main() {
  if (gl_GlobalInvocationID.x * OPERAND_COUNT >= operands.length()) return;
  next = 0u;
#include "../tests/gpu/parity_answers.h"
}
