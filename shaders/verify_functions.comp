#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require

// Calls one of the functions that render on operands from a buffer: what `vernier verify` tests is what runs.

#include "shared/glsl.h"
#include "specialization.glsl"
#include "shared/verify_functions.h"
#include "blinn.glsl"
#include "fresnel.glsl"

layout(local_size_x = 64) in;
layout(constant_id = SPECIALIZATION_FUNCTION) const uint FUNCTION = 0u;
layout(set = 0, binding = 0, scalar) readonly buffer Operands { float operands[]; };
layout(set = 0, binding = 1, scalar) writeonly buffer Answers { float answers[]; };

uint first_answer;
float operand(uint i) { return operands[gl_GlobalInvocationID.x * VERIFY_OPERANDS + i]; }
vec3 operand_vector(uint i) { return vec3(operand(i), operand(i + 1u), operand(i + 2u)); }
void answer(uint i, float value) { answers[gl_GlobalInvocationID.x * VERIFY_ANSWERS + i] = value; }
void answer_vector(uint i, vec3 v) {
  answer(i, v.x);
  answer(i + 1u, v.y);
  answer(i + 2u, v.z);
}

void main() {
  if (gl_GlobalInvocationID.x * VERIFY_OPERANDS >= operands.length()) return;
  switch (FUNCTION) {
    case VERIFY_FRESNEL: {
      Fresnel fresnel = fresnel_dielectric(operand(0u), operand(1u));
      answer(0u, fresnel.reflected);
      answer(1u, fresnel.transmitted);
      answer(2u, fresnel.refracted_cosine);
      break;
    }
    case VERIFY_HIGHLIGHT:
      answer(0u, blinn_highlight(operand_vector(0u), operand_vector(3u), operand_vector(6u), operand(9u)));
      break;
    case VERIFY_UNIT_VECTOR:
      answer_vector(0u, unit_vector(operand_vector(0u)));
      break;
  }
}
