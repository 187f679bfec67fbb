// The common ground of GLSL and C++: parameter directions and, for C++, the GLSL names that GLM brings.
#ifndef VERNIER_SHARED_GLSL_H
#define VERNIER_SHARED_GLSL_H

#ifdef __cplusplus
#include <cstdint>
#include <glm/glm.hpp>
#include <glm/integer.hpp>
#define IN(type) const type&
#define OUT(type) type&
#define INOUT(type) type&
#define precise
#define THREAD_PRIVATE static thread_local
#else
#define IN(type) in type
#define OUT(type) out type
#define INOUT(type) inout type
#define THREAD_PRIVATE
#endif

#endif
