// The second condition of a kernel's loops. Where a round is work, a loop tests at the end of its body: llvmpipe goes once more
// through the whole body of one that tests before it, for no lane at all. Counts go up in the body too: what a `for` does between
// rounds costs llvmpipe that round as well.
#ifndef VERNIER_LOOP_LIMIT_GLSL
#define VERNIER_LOOP_LIMIT_GLSL

#include "shared/glsl.h"

// No loop takes as many rounds. llvmpipe leaves loops silently after 65535 rounds in all, and a compiler that sees a loop end
// on `running` alone may take `running` for false behind it; with a second reason to end it may not.
const uint LOOP_ROUND_LIMIT = 1u << 30;

#endif
