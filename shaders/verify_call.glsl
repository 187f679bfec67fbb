// A call of a shader function by `vernier verify`: operands from a buffer, answers into another. What verify_*.comp calls is
// what renders.
#ifndef VERNIER_VERIFY_CALL_GLSL
#define VERNIER_VERIFY_CALL_GLSL

#include "shared/glsl.h"
#include "specialization.glsl"
#include "shared/verify_functions.h"

layout(local_size_x = 64) in;
layout(constant_id = SPECIALIZATION_FUNCTION) const uint FUNCTION = 0u;
layout(set = 0, binding = 0, scalar) readonly buffer Operands { float operands[]; };
layout(set = 0, binding = 1, scalar) writeonly buffer Answers { float answers[]; };

bool is_called() { return gl_GlobalInvocationID.x * VERIFY_OPERANDS < operands.length(); }
float operand(uint i) { return operands[gl_GlobalInvocationID.x * VERIFY_OPERANDS + i]; }
vec3 operand_vector(uint i) { return vec3(operand(i), operand(i + 1u), operand(i + 2u)); }
// Writes word i of the answer.
void answer(uint i, float value) { answers[gl_GlobalInvocationID.x * VERIFY_ANSWERS + i] = value; }
// Writes words i to i + 2 of the answer.
void answer_vector(uint i, vec3 v) {
  answer(i, v.x);
  answer(i + 1u, v.y);
  answer(i + 2u, v.z);
}

#endif
