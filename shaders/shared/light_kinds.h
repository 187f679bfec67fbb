// Ids of light kinds, read by C++ and GLSL alike.
#ifndef VERNIER_SHARED_LIGHT_KINDS_H
#define VERNIER_SHARED_LIGHT_KINDS_H

#define LIGHT_POINT 0u
#define LIGHT_SPOT 1u
#define LIGHT_DIRECTIONAL 2u

#endif
