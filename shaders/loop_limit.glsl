// The second condition of a kernel's loops.
#ifndef VERNIER_LOOP_LIMIT_GLSL
#define VERNIER_LOOP_LIMIT_GLSL

#include "shared/glsl.h"

// No loop takes as many rounds. llvmpipe leaves loops silently after 65535 rounds in all, and a compiler that sees a loop end
// on `running` alone may take `running` for false behind it; with a second reason to end it may not.
const uint LOOP_ROUND_LIMIT = 1u << 30;

#endif
