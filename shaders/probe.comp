#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/probe_slots.h"

// What this device's arithmetic does where the specification leaves a choice. All operands are read from a buffer, or the
// compiler would answer in the driver's place.

layout(local_size_x = PROBE_GROUP_SIZE) in;
layout(set = 0, binding = 0, scalar) readonly buffer Operands { float operands[]; };
layout(set = 0, binding = 1, scalar) writeonly buffer Answers { uint answers[]; };

float two_sum_error_precise(float a, float b) {
  precise float sum = a + b;
  precise float b_part = sum - a;
  precise float error = (a - (sum - b_part)) + (b - b_part);
  return error;
}

float two_sum_error(float a, float b) {
  float sum = a + b;
  float b_part = sum - a;
  return (a - (sum - b_part)) + (b - b_part);
}

void answer(uint slot, float value) { answers[slot] = floatBitsToUint(value); }

void answer_facts() {
  float a = operands[PROBE_FACTOR];
  float c = operands[PROBE_ADDEND];
  precise float precise_sum = a * a + c;
  answer(PROBE_FMA, fma(a, a, c));
  answer(PROBE_PLAIN_SUM, operands[PROBE_PLAIN_FACTOR] * operands[PROBE_PLAIN_FACTOR] + operands[PROBE_PLAIN_ADDEND]);
  answer(PROBE_PRECISE_SUM, precise_sum);
  float one = operands[PROBE_ONE];
  answer(PROBE_TWO_SUM, two_sum_error(operands[PROBE_PLAIN_ONE], operands[PROBE_PLAIN_TINY]));
  answer(PROBE_TWO_SUM_PRECISE, two_sum_error_precise(one, operands[PROBE_TINY]));
  float denormal = operands[PROBE_DENORMAL];
  answer(PROBE_DENORMAL_SUM, denormal + denormal);
  answer(PROBE_DENORMAL_PRODUCT, denormal * operands[PROBE_THREE]);
  float nan = operands[PROBE_NAN];
  answer(PROBE_MIN_NAN_FIRST, min(nan, one));
  answer(PROBE_MIN_NAN_SECOND, min(one, nan));
  answer(PROBE_MAX_NAN_FIRST, max(nan, one));
  answer(PROBE_MAX_NAN_SECOND, max(one, nan));
  answers[PROBE_ISNAN] = isnan(nan) ? 1u : 0u;
}

void main() {
  uint pair = gl_GlobalInvocationID.x;
  if (pair == 0u) answer_facts();
  if (pair >= PROBE_DIVISION_COUNT) return;
  float dividend = operands[PROBE_OPERAND_COUNT + 2u * pair];
  float divisor = operands[PROBE_OPERAND_COUNT + 2u * pair + 1u];
  answer(PROBE_ANSWER_COUNT + pair, dividend / divisor);
}
