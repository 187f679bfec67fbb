// Functions that verify_functions.comp calls, one per pipeline, and the words of a call. Read by C++ and GLSL alike.
#ifndef VERNIER_SHARED_VERIFY_FUNCTIONS_H
#define VERNIER_SHARED_VERIFY_FUNCTIONS_H

#define VERIFY_OPERANDS 16u  // words per call
#define VERIFY_ANSWERS 16u   // and per answer

#define VERIFY_FRESNEL 0u     // cosine, eta -> reflected, transmitted, refracted_cosine
#define VERIFY_HIGHLIGHT 1u   // normal 3, to_light 3, to_viewer 3, exponent -> highlight
#define VERIFY_UNIT_VECTOR 2u  // v 3 -> unit vector 3

#endif
