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
THREAD_PRIVATE uint g0, g1, g2, g3, g4, g5, g6, g7, g8, g9;

// What waits below those in a deep tree, the next one in l0. Of the searches one in a thousand fills
// SHIFTED_GROUPS: it stops for as long as it takes to move one down or, when none is left above, up.
THREAD_PRIVATE uint l0, l1, l2, l3, l4, l5, l6, l7, l8, l9, l10, l11, l12, l13, l14, l15, l16, l17, l18, l19, l20, l21, l22, l23;
const uint SHIFTED_GROUPS = 8u;

// A stack of up to two more entries is shifted as a whole: looking for what waits below takes as long.
bool has_lower_groups() { return SHIFT_STACK && TRAVERSAL_STACK_SIZE > SHIFTED_GROUPS + 2u; }

// Entry i exists only in a stack of more than i.
#define MOVE_ENTRY(i, to, from) \
  if ((has_lower_groups() ? SHIFTED_GROUPS : TRAVERSAL_STACK_SIZE) > uint(i)) to = from;
// One more than can wait there, so that a 0 comes up from below.
#define MOVE_LOWER(i, to, from) \
  if (TRAVERSAL_STACK_SIZE - SHIFTED_GROUPS >= uint(i)) to = from;
#define SHIFT_UP                                                                                                \
  MOVE_ENTRY(9, g9, g8) MOVE_ENTRY(8, g8, g7) MOVE_ENTRY(7, g7, g6) MOVE_ENTRY(6, g6, g5) MOVE_ENTRY(5, g5, g4) \
  MOVE_ENTRY(4, g4, g3) MOVE_ENTRY(3, g3, g2) MOVE_ENTRY(2, g2, g1) MOVE_ENTRY(1, g1, g0)
#define SHIFT_DOWN                                                                                              \
  MOVE_ENTRY(1, g0, g1) MOVE_ENTRY(2, g1, g2) MOVE_ENTRY(3, g2, g3) MOVE_ENTRY(4, g3, g4) MOVE_ENTRY(5, g4, g5) \
  MOVE_ENTRY(6, g5, g6) MOVE_ENTRY(7, g6, g7) MOVE_ENTRY(8, g7, g8) MOVE_ENTRY(9, g8, g9)
#define SHIFT_LOWER_UP                                                                                          \
  MOVE_LOWER(23, l23, l22) MOVE_LOWER(22, l22, l21) MOVE_LOWER(21, l21, l20) MOVE_LOWER(20, l20, l19)           \
  MOVE_LOWER(19, l19, l18) MOVE_LOWER(18, l18, l17) MOVE_LOWER(17, l17, l16) MOVE_LOWER(16, l16, l15)           \
  MOVE_LOWER(15, l15, l14) MOVE_LOWER(14, l14, l13) MOVE_LOWER(13, l13, l12) MOVE_LOWER(12, l12, l11)           \
  MOVE_LOWER(11, l11, l10) MOVE_LOWER(10, l10, l9) MOVE_LOWER(9, l9, l8) MOVE_LOWER(8, l8, l7)                  \
  MOVE_LOWER(7, l7, l6) MOVE_LOWER(6, l6, l5) MOVE_LOWER(5, l5, l4) MOVE_LOWER(4, l4, l3) MOVE_LOWER(3, l3, l2) \
  MOVE_LOWER(2, l2, l1) MOVE_LOWER(1, l1, l0)
#define SHIFT_LOWER_DOWN                                                                                          \
  MOVE_LOWER(1, l0, l1) MOVE_LOWER(2, l1, l2) MOVE_LOWER(3, l2, l3) MOVE_LOWER(4, l3, l4) MOVE_LOWER(5, l4, l5)   \
  MOVE_LOWER(6, l5, l6) MOVE_LOWER(7, l6, l7) MOVE_LOWER(8, l7, l8) MOVE_LOWER(9, l8, l9) MOVE_LOWER(10, l9, l10) \
  MOVE_LOWER(11, l10, l11) MOVE_LOWER(12, l11, l12) MOVE_LOWER(13, l12, l13) MOVE_LOWER(14, l13, l14)             \
  MOVE_LOWER(15, l14, l15) MOVE_LOWER(16, l15, l16) MOVE_LOWER(17, l16, l17) MOVE_LOWER(18, l17, l18)             \
  MOVE_LOWER(19, l18, l19) MOVE_LOWER(20, l19, l20) MOVE_LOWER(21, l20, l21) MOVE_LOWER(22, l21, l22)             \
  MOVE_LOWER(23, l22, l23)

// The shifted stack needs no count: what lies below its lowest entry is 0, which no group is. One with instances is counted
// all the same, since the way back out of them hangs on the count, and so is one that a seeded fault makes too short.
bool counts_stack() { return !SHIFT_STACK || INSTANCED || mutated(MUTATION_SHORT_STACK); }

// Makes the stack one without entries.
void clear_stack() {
  if (SHIFT_STACK) g0 = g1 = g2 = g3 = g4 = g5 = g6 = g7 = g8 = g9 = 0u;
  if (has_lower_groups()) {
    l0 = l1 = l2 = l3 = l4 = l5 = l6 = l7 = l8 = l9 = l10 = l11 = 0u;
    l12 = l13 = l14 = l15 = l16 = l17 = l18 = l19 = l20 = l21 = l22 = l23 = 0u;
  }
}

// The group on top of `count` entries; 0, which no group is, where there is none.
uint top_group(IN(uint) count) {
  if (SHIFT_STACK) return g0;
  return count == 0u ? 0u : traversal_groups[max(count, 1u) - 1u];
}

// Adds `group` on top of `count` entries. Not to be called where top_is_full().
void push_group(INOUT(uint) count, IN(uint) group) {
  if (SHIFT_STACK) {
    SHIFT_UP
    g0 = group;
  } else {
    traversal_groups[count] = group;
  }
  if (counts_stack()) count++;
}

// Takes the top entry off, where there is one. It counts as taken off too where it was moved down: take_lower_group() brings it.
void pop_group(INOUT(uint) count) {
  if (SHIFT_STACK) {
    SHIFT_DOWN
  }
  if (counts_stack() && count > 0u) count--;
}

// Whether an entry has to be moved down before another is added.
bool top_is_full() { return has_lower_groups() && g7 != 0u; }

// Moves the lowest of the shifted entries down; only where top_is_full().
void lower_group() {
  SHIFT_LOWER_UP
  l0 = g7;
  g7 = 0u;
}

// Takes the uppermost entry off that was moved down, and 0 where there is none; only where no other waits above it.
uint take_lower_group() {
  uint group = l0;
  if (group != 0u) {
    SHIFT_LOWER_DOWN
  }
  return group;
}

#endif
