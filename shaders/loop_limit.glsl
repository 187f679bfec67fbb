// How the loops of kernels end. llvmpipe looks at its mask of lanes behind the body alone: it goes once more through the whole
// body of a loop that tests before it, for no lane at all. So where a round is work, loops test behind the body if TEST_LAST says
// so, and count in the body, as what a `for` does between rounds costs that round too. Elsewhere they test before it: SwiftShader
// loses hits where lanes leave a loop behind its body while others stay, presumably since it does not mask what the body made. One
// that all lanes leave together tests behind its body everywhere. That of trace_jobs goes on for hundreds of rounds: one more is
// not worth the words.
#ifndef VERNIER_LOOP_LIMIT_GLSL
#define VERNIER_LOOP_LIMIT_GLSL

#include "shared/glsl.h"

// The second condition of loops: none takes as many rounds. llvmpipe leaves loops silently after 65535 rounds in all, and a
// compiler that sees a loop end on `running` alone may take `running` for false behind it; with a second reason to end it may not.
const uint LOOP_ROUND_LIMIT = 1u << 30;

#endif
