// The stack of a traversal: groups of siblings still to be visited (traverse_bvh.glsl). Its size is the BVH's depth, so it
// cannot overflow: at most one group waits per level.
#ifndef VERNIER_TRAVERSAL_STACK_GLSL
#define VERNIER_TRAVERSAL_STACK_GLSL

#include "shared/glsl.h"

THREAD_PRIVATE uint traversal_groups[TRAVERSAL_STACK_SIZE];

// llvmpipe spends 90 ns on a store to an indexed array under a mask, 4 on shifting eight registers: there the top is
// always entry 0 and a push or pop moves them all (constant indices after unrolling).
void push_group(IN(uint) count, IN(uint) group) {
  if (SHIFT_STACK) {
    for (uint i = TRAVERSAL_STACK_SIZE - 1u; i > 0u; i--) traversal_groups[i] = traversal_groups[i - 1u];
    traversal_groups[0] = group;
  } else {
    traversal_groups[count] = group;
  }
}

// `count` is the number of entries without the one that is taken.
uint pop_group(IN(uint) count) {
  if (!SHIFT_STACK) return traversal_groups[count];
  uint group = traversal_groups[0];
  for (uint i = 1u; i < TRAVERSAL_STACK_SIZE; i++) traversal_groups[i - 1u] = traversal_groups[i];
  return group;
}

#endif
