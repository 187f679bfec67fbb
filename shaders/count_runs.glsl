// Counters of how often each effect ran, and of rays by depth. Called with COUNT_EFFECTS only.
#ifndef VERNIER_COUNT_RUNS_GLSL
#define VERNIER_COUNT_RUNS_GLSL

#include "effect_runs.glsl"
#include "shared/film_layout.h"

void count_bit(IN(uint) bit) { add_to_counter(COUNTER_EFFECT_RUNS + bit, (effects_run >> bit) & 1u); }

void count_four_bits(IN(uint) bit) {
  count_bit(bit);
  count_bit(bit + 1u);
  count_bit(bit + 2u);
  count_bit(bit + 3u);
}

// Adds what was noted to the counters. No loop: a driver's loop limit could end it, and counts would be lost silently.
void count_runs() {
  count_four_bits(0u);
  count_four_bits(4u);
  count_four_bits(8u);
  count_four_bits(12u);
  count_four_bits(16u);
  count_four_bits(20u);
  count_four_bits(24u);
  count_four_bits(28u);
  effects_run = 0u;
}

// `depth` as an index of the counters by depth.
uint counted_depth(IN(uint) depth) { return depth < COUNTED_DEPTHS ? depth : COUNTED_DEPTHS - 1u; }

#endif
