#ifndef VERNIER_SHARED_PROBE_SLOTS_H
#define VERNIER_SHARED_PROBE_SLOTS_H

// Layout of the two buffers of probe.comp. Operands: the slots below, then (dividend, divisor) pairs.
#define PROBE_FACTOR 0u
#define PROBE_ADDEND 1u
#define PROBE_ONE 2u
#define PROBE_TINY 3u
#define PROBE_DENORMAL 4u
#define PROBE_THREE 5u
#define PROBE_NAN 6u
// The same values again for the expressions without `precise`: with the same operands the driver's common subexpression
// elimination answers them from the precise ones.
#define PROBE_PLAIN_FACTOR 7u
#define PROBE_PLAIN_ADDEND 8u
#define PROBE_PLAIN_ONE 9u
#define PROBE_PLAIN_TINY 10u
#define PROBE_OPERAND_COUNT 11u

// Answers, as bits of floats (PROBE_ISNAN: 0 or 1): the slots below, then the quotients.
#define PROBE_FMA 0u
#define PROBE_PLAIN_SUM 1u
#define PROBE_PRECISE_SUM 2u
#define PROBE_TWO_SUM 3u
#define PROBE_TWO_SUM_PRECISE 4u
#define PROBE_DENORMAL_SUM 5u
#define PROBE_DENORMAL_PRODUCT 6u
#define PROBE_MIN_NAN_FIRST 7u
#define PROBE_MIN_NAN_SECOND 8u
#define PROBE_MAX_NAN_FIRST 9u
#define PROBE_MAX_NAN_SECOND 10u
#define PROBE_ISNAN 11u
#define PROBE_ANSWER_COUNT 12u

#define PROBE_GROUP_SIZE 64
#define PROBE_DIVISION_COUNT 65536u

#endif
