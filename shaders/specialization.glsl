// The specialization constants of what renders. Ids: shared/specialization_ids.h.
#ifndef VERNIER_SPECIALIZATION_GLSL
#define VERNIER_SPECIALIZATION_GLSL

#include "shared/accuracy.h"
#include "shared/effects.h"
#include "shared/material_flags.h"
#include "shared/specialization_ids.h"

layout(constant_id = SPECIALIZATION_EFFECTS) const uint EFFECTS = 0xffffffffu;
layout(constant_id = SPECIALIZATION_TRAVERSAL_STACK) const uint TRAVERSAL_STACK_SIZE = 64u;
layout(constant_id = SPECIALIZATION_SHIFT_STACK) const bool SHIFT_STACK = false;
layout(constant_id = SPECIALIZATION_PATH_STACK) const uint PATH_STACK_SIZE = 18u;
layout(constant_id = SPECIALIZATION_COUNT_COST) const bool COUNT_COST = false;
layout(constant_id = SPECIALIZATION_COUNT_EFFECTS) const bool COUNT_EFFECTS = false;
layout(constant_id = SPECIALIZATION_LISTED_PIXELS) const bool LISTED_PIXELS = false;
layout(constant_id = SPECIALIZATION_INSTANCED) const bool INSTANCED = false;
layout(constant_id = SPECIALIZATION_COARSE) const bool COARSE = false;
layout(constant_id = SPECIALIZATION_TEST_LAST) const bool TEST_LAST = false;
layout(constant_id = SPECIALIZATION_WORKFLOWS) const uint WORKFLOWS = ALL_WORKFLOWS;

layout(constant_id = SPECIALIZATION_LEVELS) const uint LEVELS = LEVELS_OF(LEVEL_ROBUST);
layout(constant_id = SPECIALIZATION_MUTATION) const uint MUTATION = MUTATION_NONE;

bool effect_on(const uint effect) { return (EFFECTS & effect) != 0u; }

// LEVEL_* of a spot.
uint level_at(const uint spot) { return (LEVELS >> (2u * spot)) & 3u; }

// Whether this fault is seeded.
bool mutated(const uint mutation) { return MUTATION == mutation; }

#endif
