// The stack of a traversal: groups of siblings still to be visited (traverse_bvh.glsl). At most one group waits per level of
// the BVH but the lowest, and the stack has as many entries as the BVH has levels: it cannot overflow.
#ifndef VERNIER_TRAVERSAL_STACK_GLSL
#define VERNIER_TRAVERSAL_STACK_GLSL

#include "shared/accuracy.h"
#include "shared/glsl.h"
#include "shared/specialization_ids.h"

THREAD_PRIVATE uint traversal_groups[TRAVERSAL_STACK_SIZE];

// The same as plain variables, the top always in g0: a push or pop moves them all. llvmpipe spends 90 ns on a store to an
// indexed array under a mask and 4 on moving eight variables; an array that is shifted by a loop it keeps in memory.
THREAD_PRIVATE uint g0, g1, g2, g3, g4, g5, g6, g7, g8, g9, g10, g11, g12, g13, g14, g15, g16, g17, g18, g19, g20, g21, g22,
    g23;

// Entry i exists only in a stack of more than i.
#define MOVE_ENTRY(i, to, from) \
  if (TRAVERSAL_STACK_SIZE > uint(i)) to = from;
#define SHIFT_UP                                                                                          \
  MOVE_ENTRY(23, g23, g22) MOVE_ENTRY(22, g22, g21) MOVE_ENTRY(21, g21, g20) MOVE_ENTRY(20, g20, g19)                   \
  MOVE_ENTRY(19, g19, g18) MOVE_ENTRY(18, g18, g17) MOVE_ENTRY(17, g17, g16) MOVE_ENTRY(16, g16, g15)                   \
  MOVE_ENTRY(15, g15, g14) MOVE_ENTRY(14, g14, g13) MOVE_ENTRY(13, g13, g12) MOVE_ENTRY(12, g12, g11)                   \
  MOVE_ENTRY(11, g11, g10) MOVE_ENTRY(10, g10, g9) MOVE_ENTRY(9, g9, g8) MOVE_ENTRY(8, g8, g7) MOVE_ENTRY(7, g7, g6)     \
  MOVE_ENTRY(6, g6, g5) MOVE_ENTRY(5, g5, g4) MOVE_ENTRY(4, g4, g3) MOVE_ENTRY(3, g3, g2) MOVE_ENTRY(2, g2, g1)          \
  MOVE_ENTRY(1, g1, g0)
#define SHIFT_DOWN                                                                                            \
  MOVE_ENTRY(1, g0, g1) MOVE_ENTRY(2, g1, g2) MOVE_ENTRY(3, g2, g3) MOVE_ENTRY(4, g3, g4) MOVE_ENTRY(5, g4, g5)          \
  MOVE_ENTRY(6, g5, g6) MOVE_ENTRY(7, g6, g7) MOVE_ENTRY(8, g7, g8) MOVE_ENTRY(9, g8, g9) MOVE_ENTRY(10, g9, g10)        \
  MOVE_ENTRY(11, g10, g11) MOVE_ENTRY(12, g11, g12) MOVE_ENTRY(13, g12, g13) MOVE_ENTRY(14, g13, g14)                   \
  MOVE_ENTRY(15, g14, g15) MOVE_ENTRY(16, g15, g16) MOVE_ENTRY(17, g16, g17) MOVE_ENTRY(18, g17, g18)                   \
  MOVE_ENTRY(19, g18, g19) MOVE_ENTRY(20, g19, g20) MOVE_ENTRY(21, g20, g21) MOVE_ENTRY(22, g21, g22)                   \
  MOVE_ENTRY(23, g22, g23)

// The shifted stack needs no count: what lies below its lowest entry is 0, which no group is. One with instances is counted
// all the same, since the way back out of them hangs on the count, and so is one that a seeded fault makes too short.
bool counts_stack() { return !SHIFT_STACK || INSTANCED || mutated(MUTATION_SHORT_STACK); }

// Makes the stack one without entries.
void clear_stack() {
  if (!counts_stack()) {
    g0 = g1 = g2 = g3 = g4 = g5 = g6 = g7 = g8 = g9 = g10 = g11 = 0u;
    g12 = g13 = g14 = g15 = g16 = g17 = g18 = g19 = g20 = g21 = g22 = g23 = 0u;
  }
}

// The group on top of `count` entries; 0, which no group is, where there is none.
uint top_group(IN(uint) count) {
  if (SHIFT_STACK) return counts_stack() && count == 0u ? 0u : g0;
  return count == 0u ? 0u : traversal_groups[max(count, 1u) - 1u];
}

// Adds `group` on top of `count` entries.
void push_group(INOUT(uint) count, IN(uint) group) {
  if (SHIFT_STACK) {
    SHIFT_UP
    g0 = group;
  } else {
    traversal_groups[count] = group;
  }
  if (counts_stack()) count++;
}

// Takes the top entry off, where there is one.
void pop_group(INOUT(uint) count) {
  if (SHIFT_STACK) {
    SHIFT_DOWN
  }
  if (counts_stack() && count > 0u) count--;
}

#endif
