// Which effects ran: only in pipelines made with COUNT_EFFECTS, else nothing of it is left. What runs is noted on the spot,
// in a word of the invocation; count_runs.glsl counts it once a search.
#ifndef VERNIER_EFFECT_RUNS_GLSL
#define VERNIER_EFFECT_RUNS_GLSL

#include "shared/effects.h"

// Effects that have run since they were last counted: an OR of EFFECT_*.
uint effects_run = 0u;

// Says that `effects` have run; stands where the work is done.
void note_run(IN(uint) effects) {
  if (COUNT_EFFECTS) effects_run |= effects;
}

#endif
